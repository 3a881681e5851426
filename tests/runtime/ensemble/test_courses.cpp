// Trajectories with sizes and numbers of steps of their own.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cstdint>
#include <limits>
#include <stdexcept>

#include <catch2/catch.hpp>

#include "steppers.hpp"

using namespace ensemble_test;

namespace {

/// Sizes and numbers of steps, so that trajectories leave their lanes at different times.
struct Courses {
    std::vector<double> h;
    std::vector<std::int64_t> steps;
};

Courses courses(std::size_t count) {
    Courses result;
    for (std::size_t i = 0; i < count; ++i) {
        const double part = 1 + static_cast<double>(i % 5) / 4;
        result.h.push_back((i % 7 == 4 ? -1.0 : 1.0) * part / 64);
        result.steps.push_back(static_cast<std::int64_t>((i * i * 5 + 3) % 41));
    }
    return result;
}

/// The trajectory i of an ensemble that went its course twice is as if it were alone.
template <class Many>
void check_alone(const hvi::Ensemble<Many>& ensemble, const typename Many::Trajectory& start,
                 const Courses& by, std::size_t i) {
    hvi::Ensemble<Many> alone({start});
    for (const int again : {0, 1}) { alone.advance(by.h[i], by.steps[i] * (1 + again)); }
    CHECK(same_bits(ensemble.state(i), alone.state(0)));
    CHECK(ensemble.steps(i) == alone.steps(0));
    CHECK(ensemble.status(i).code() == alone.status(0).code());
    CHECK(ensemble.status(i).iterations == alone.status(0).iterations);
}

}  // namespace

TEMPLATE_TEST_CASE("a trajectory goes its own course", "", HVI_EXPLICIT_PAIRS, HVI_IMPLICIT_PAIRS) {
    using Many = typename TestType::Many;
    const auto x = starts<Many>(27);
    Courses by = courses(x.size());
    for (const unsigned threads : {1U, 3U}) {
        hvi::Ensemble<Many> ensemble(x);
        ensemble.advance(by.h, by.steps, threads);
        std::vector<std::int64_t> twice;
        for (const std::int64_t steps : by.steps) { twice.push_back(2 * steps); }
        ensemble.advance(by.h, twice, threads);
        for (std::size_t i = 0; i < x.size(); ++i) { check_alone(ensemble, x[i], by, i); }
    }
}

TEMPLATE_TEST_CASE("a step back leads to where it came from", "", VerletKepler, KahanLiKepler,
                   Gauss4Kepler, Gauss3Swing) {
    using Many = typename TestType::Many;
    const auto x = starts<Many>(12);
    Courses by = courses(x.size());
    hvi::Ensemble<Many> ensemble(x);
    ensemble.advance(by.h, by.steps);
    for (double& h : by.h) { h = -h; }
    ensemble.advance(by.h, by.steps);
    for (std::size_t i = 0; i < x.size(); ++i) {
        for (std::size_t k = 0; k < dimension<Many>; ++k) {
            CHECK(ensemble.state(i).q[k] == Approx(x[i].q[k]).margin(1e-13));
            CHECK(ensemble.state(i).p[k] == Approx(x[i].p[k]).margin(1e-13));
        }
    }
}

TEMPLATE_TEST_CASE("one without steps, or with steps of size 0, keeps every bit", "", VerletKepler,
                   KahanLiKepler, Gauss4Kepler) {
    using Many = typename TestType::Many;
    const auto x = starts<Many>(10);
    Courses by = courses(x.size());
    by.steps[1] = 0;
    by.steps[2] = -5;
    by.h[3] = 0;
    by.steps[3] = 6;
    hvi::Ensemble<Many> ensemble(x);
    ensemble.advance(by.h, by.steps);
    CHECK(ensemble.ok());
    for (const std::size_t i : {1U, 2U, 3U}) { CHECK(same_bits(ensemble.state(i), x[i])); }
    CHECK(ensemble.steps(1) == 0);
    CHECK(ensemble.steps(2) == 0);
    CHECK(ensemble.steps(3) == 6);
}

TEMPLATE_TEST_CASE("one that stops leaves its lane", "", HVI_EXPLICIT_PAIRS, HVI_IMPLICIT_PAIRS) {
    using Many = typename TestType::Many;
    auto x = starts<Many>(20);
    Courses by = courses(x.size());
    x[2].p[0] = std::numeric_limits<double>::quiet_NaN();
    by.steps[2] = 1000;
    by.h[6] = std::numeric_limits<double>::infinity();
    by.steps[6] = 1000;
    hvi::Ensemble<Many> ensemble(x);
    ensemble.advance(by.h, by.steps);
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (i == 2 || i == 6) {
            CHECK_FALSE(ensemble.status(i).ok());
            CHECK(ensemble.steps(i) == 0);
            CHECK(same_bits(ensemble.state(i), x[i]));
            continue;
        }
        hvi::Ensemble<Many> alone({x[i]});
        alone.advance(by.h[i], by.steps[i]);
        CHECK(same_bits(ensemble.state(i), alone.state(0)));
        CHECK(ensemble.steps(i) == by.steps[i]);
    }
}

TEMPLATE_TEST_CASE("one that begins where another has ended knows nothing of it", "",
                   VerletPendulum, KahanLiKepler, Gauss4Kepler, Gauss3Nonseparable, Gauss5Pushed) {
    using Many = typename TestType::Many;
    constexpr double h = 1.0 / 32;
    auto x = starts<Many>(8);
    hvi::Ensemble<Many> first({x[0]});
    first.advance(h, 5);
    x.push_back(first.state(0));  // it takes the lane of the first, whose steps are over first
    const std::vector<double> sizes(9, h);
    for (const std::int64_t last : {1, 50}) {
        std::vector<std::int64_t> steps(9, 50);
        steps[0] = 5;
        steps[8] = last;
        hvi::Ensemble<Many> ensemble(x);
        ensemble.advance(sizes, steps, 1);
        hvi::Ensemble<Many> alone({x[8]});
        alone.advance(h, last);
        CHECK(same_bits(ensemble.state(8), alone.state(0)));
        // Starting values of the step before would leave less to iterate.
        CHECK(ensemble.status(8).iterations == alone.status(0).iterations);
    }
}

TEST_CASE("steppers of one trajectory go courses, too") {
    using One = VerletPendulum::One;
    std::vector<One::State> x(5, One::initial());
    const Courses by = courses(x.size());
    hvi::Ensemble<One> ensemble(x);
    ensemble.advance(by.h, by.steps, 2);
    for (std::size_t i = 0; i < x.size(); ++i) {
        One stepper;
        for (std::int64_t step = 0; step < by.steps[i]; ++step) {
            REQUIRE(stepper.step(x[i], by.h[i]).ok());
        }
        CHECK(same_bits(ensemble.state(i), x[i]));
        CHECK(ensemble.steps(i) == by.steps[i]);
    }
}

TEST_CASE("there are as many courses as trajectories") {
    using Many = VerletKepler::Many;
    hvi::Ensemble<Many> ensemble(starts<Many>(3));
    const std::vector<double> two(2, 0.1), three(3, 0.1);
    CHECK_THROWS_AS(ensemble.advance(two, {1, 1, 1}), std::invalid_argument);
    CHECK_THROWS_AS(ensemble.advance(three, {1, 1}), std::invalid_argument);
    hvi::Ensemble<Many> none({});
    none.advance(std::vector<double>(), std::vector<std::int64_t>());
    CHECK(none.ok());
}
