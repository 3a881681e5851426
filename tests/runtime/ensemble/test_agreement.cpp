// Ensembles against steppers of one trajectory.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <cstdlib>

#include <catch2/catch.hpp>

#include "steppers.hpp"

using namespace ensemble_test;

namespace {

constexpr double h = 1.0 / 64;

/// Compares one step of both kinds, from equal states.
template <class Pair>
void compare_steps(int most_iterations_apart) {
    const auto x = starts<typename Pair::Many>(64);
    hvi::Ensemble<typename Pair::Many> ensemble(x);
    ensemble.advance(h, 1, 1);
    double worst = 0;
    int apart = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        typename Pair::One stepper;
        auto y = x[i];
        const hvi::Status status = stepper.step(y, h);
        REQUIRE(status.ok());
        REQUIRE(ensemble.status(i).ok());
        CHECK(ensemble.steps(i) == 1);
        worst = std::fmax(worst, distance(ensemble.state(i), y));
        apart = std::max(apart, std::abs(status.iterations - ensemble.status(i).iterations));
    }
    CHECK(worst <= 4);
    CHECK(apart <= most_iterations_apart);
}

/// Many steps: rounding grows with time, and with compensated sums hardly.
template <class Pair>
void compare_runs(double most) {
    const auto x = starts<typename Pair::Many>(16);
    hvi::Ensemble<typename Pair::Many> ensemble(x);
    ensemble.advance(h, 500, 2);
    ensemble.advance(h, 500, 2);
    for (std::size_t i = 0; i < x.size(); ++i) {
        typename Pair::One stepper;
        auto y = x[i];
        for (int step = 0; step < 1000; ++step) { REQUIRE(stepper.step(y, h).ok()); }
        CHECK(ensemble.steps(i) == 1000);
        CHECK(distance(ensemble.state(i), y) <= most);
    }
}

}  // namespace

TEMPLATE_TEST_CASE("a step is that of one trajectory, to rounding", "", HVI_EXPLICIT_PAIRS) {
    compare_steps<TestType>(0);
    compare_runs<TestType>(1e5);
}

TEMPLATE_TEST_CASE("an implicit step is, and iterates as often", "", HVI_IMPLICIT_PAIRS) {
    // NOTE: rounding decides which of the last iterations no longer changes anything.
    compare_steps<TestType>(3);
    compare_runs<TestType>(1e4);
}

TEMPLATE_TEST_CASE("a step back leads back", "", HVI_EXPLICIT_PAIRS, HVI_IMPLICIT_PAIRS) {
    using Many = typename TestType::Many;
    if (std::is_same_v<TestType, EulerPendulum>) { return; }  // its adjoint leads back
    const auto x = starts<Many>(9);
    hvi::Ensemble<Many> ensemble(x);
    ensemble.advance(h, 100);
    CHECK(distance(ensemble.state(8), x[8]) > 1e10);
    ensemble.advance(-h, 100);
    REQUIRE(ensemble.ok());
    for (std::size_t i = 0; i < x.size(); ++i) { CHECK(distance(ensemble.state(i), x[i]) < 1e4); }
}

TEMPLATE_TEST_CASE("a step of size 0 leaves every bit", "", HVI_EXPLICIT_PAIRS,
                   HVI_IMPLICIT_PAIRS) {
    using Many = typename TestType::Many;
    const auto x = starts<Many>(9);
    hvi::Ensemble<Many> once(x), twice(x);
    once.advance(h, 3);
    twice.advance(0.0, 5);
    for (std::size_t i = 0; i < x.size(); ++i) { CHECK(same_bits(twice.state(i), x[i])); }
    twice.advance(h, 3);
    for (std::size_t i = 0; i < x.size(); ++i) { CHECK(same_bits(once.state(i), twice.state(i))); }
}

TEST_CASE("an energy is that of a trajectory") {
    const auto x = starts<made::Gauss4Keplers>(3);
    hvi::Ensemble<made::Gauss4Keplers> ensemble(x);
    const double before = ensemble.stepper().energy(x[2]);
    CHECK(before == Approx((x[2].p[0] * x[2].p[0] + x[2].p[1] * x[2].p[1]) / 2 -
                           1 / std::hypot(x[2].q[0], x[2].q[1])));
    ensemble.advance(h, 1000);
    CHECK(std::abs(ensemble.stepper().energy(ensemble.state(2)) - before) < 1e-10);
    CHECK(std::abs(ensemble.stepper().angular_momentum(ensemble.state(2)) -
                   ensemble.stepper().angular_momentum(x[2])) < 1e-14);
}
