// Trajectories with parameters of their own.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <limits>
#include <stdexcept>

#include <catch2/catch.hpp>

#include "steppers.hpp"

using namespace ensemble_test;

namespace {

constexpr double h = 1.0 / 64;

/// Returns a number between 1/2 and 3/2 that belongs to trajectory i.
double some(std::size_t i) { return 1 + std::sin(static_cast<double>(7 * i + 1)) / 2; }

// ---- parameters of trajectory i, of either stepper of a pair ----

template <class P>
auto set(P& parameters, std::size_t i) -> decltype(parameters.mu, void()) {
    parameters.mu = some(i);
}
template <class P>
auto set(P& parameters, std::size_t i) -> decltype(parameters.m1, void()) {
    parameters.m1 = some(i);
    parameters.l2 = some(i + 1);
    parameters.g = 9 * some(i + 2);
}
template <class P>
auto set(P& parameters, std::size_t i) -> decltype(parameters.w, void()) {
    parameters.w = i % 5 == 3 ? 0 : some(i);
    parameters.a = some(i + 1);
    parameters.k = some(i + 2);
}
template <class P>
auto set(P& parameters, std::size_t i) -> decltype(parameters.c, void()) {
    parameters.c = some(i) / 2;
    parameters.g = some(i + 1);
}
template <class P>
auto set(P& parameters, std::size_t i) -> decltype(parameters.m[0], void()) {
    parameters.m[2] = some(i);
    parameters.k = 100 * some(i + 1);
}
template <class P>
auto set(P& parameters, std::size_t i) -> decltype(parameters.field, void()) {
    parameters.field = 4 * some(i);
    parameters.k = some(i + 1);
    parameters.bumps = some(i + 2) / 50;
}

template <class P>
auto one_of(P& parameters) -> decltype((parameters.mu)) {
    return parameters.mu;
}
template <class P>
auto one_of(P& parameters) -> decltype((parameters.m1)) {
    return parameters.m1;
}
template <class P>
auto one_of(P& parameters) -> decltype((parameters.w)) {
    return parameters.w;
}
template <class P>
auto one_of(P& parameters) -> decltype((parameters.c)) {
    return parameters.c;
}
template <class P>
auto one_of(P& parameters) -> decltype((parameters.m[0])) {
    return parameters.m[0];
}
template <class P>
auto one_of(P& parameters) -> decltype((parameters.field)) {
    return parameters.field;
}

template <class Stepper>
typename Stepper::Parameters parameters_of(std::size_t i) {
    typename Stepper::Parameters parameters;
    set(parameters, i);
    return parameters;
}

template <class Stepper>
std::vector<typename Stepper::Parameters> parameters(std::size_t count) {
    std::vector<typename Stepper::Parameters> result;
    for (std::size_t i = 0; i < count; ++i) { result.push_back(parameters_of<Stepper>(i)); }
    return result;
}

}  // namespace

#define HVI_PAIRS_WITH_PARAMETERS                                                                  \
    VerletKepler, KahanLiKepler, Gauss4Kepler, Gauss2DoublePendulum, Gauss3Weighed, Gauss3Joined,  \
        SplitMolecule, SplitTrap

TEMPLATE_TEST_CASE("a trajectory has its parameters", "", HVI_PAIRS_WITH_PARAMETERS) {
    using Many = typename TestType::Many;
    using One = typename TestType::One;
    const auto x = starts<Many>(21);
    for (const int steps : {1, 500}) {
        hvi::Ensemble<Many> ensemble(x, parameters<Many>(x.size()));
        ensemble.advance(h, steps, 2);
        REQUIRE(ensemble.ok());
        for (std::size_t i = 0; i < x.size(); ++i) {
            One stepper(parameters_of<One>(i));
            auto y = x[i];
            for (int step = 0; step < steps; ++step) { REQUIRE(stepper.step(y, h).ok()); }
            CHECK(distance(ensemble.state(i), y) <= (steps == 1 ? 4 : 1e5));
        }
    }
}

TEMPLATE_TEST_CASE("its bits are those of an ensemble that shares them", "",
                   HVI_PAIRS_WITH_PARAMETERS) {
    using Many = typename TestType::Many;
    const auto x = starts<Many>(19);
    for (const unsigned threads : {1U, 3U}) {
        hvi::Ensemble<Many> ensemble(x, parameters<Many>(x.size()));
        ensemble.advance(h, 40, threads);
        ensemble.advance(h, 60, threads);
        for (std::size_t i = 0; i < x.size(); ++i) {
            hvi::Ensemble<Many> shared({x[i]}, parameters_of<Many>(i));
            shared.advance(h, 40);
            shared.advance(h, 60);
            CHECK(same_bits(ensemble.state(i), shared.state(0)));
            CHECK(ensemble.status(i).iterations == shared.status(0).iterations);
        }
    }
}

TEMPLATE_TEST_CASE("one whose parameters are no number stops alone", "",
                   HVI_PAIRS_WITH_PARAMETERS) {
    using Many = typename TestType::Many;
    const auto x = starts<Many>(11);
    auto own = parameters<Many>(x.size());
    hvi::Ensemble<Many> all_well(x, own);
    one_of(own[6]) = std::numeric_limits<double>::quiet_NaN();
    hvi::Ensemble<Many> ensemble(x, own);
    all_well.advance(h, 30);
    ensemble.advance(h, 30);
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (i == 6) {
            CHECK(ensemble.status(i).code() == hvi::Status::Code::not_finite);
            CHECK(ensemble.steps(i) == 0);
            CHECK(same_bits(ensemble.state(i), x[i]));
        } else {
            CHECK(ensemble.status(i).ok());
            CHECK(same_bits(ensemble.state(i), all_well.state(i)));
        }
    }
}

TEST_CASE("momenta that do not move positions are moved by forces alone") {
    using Many = Gauss3Weighed::Many;
    const auto x = starts<Many>(5);
    hvi::Ensemble<Many> ensemble(x, parameters<Many>(5));
    ensemble.advance(h, 64);  // until t = 1
    const double q = x[3].q[0], k = parameters_of<Many>(3).k;
    CHECK(ensemble.state(3).q[0] == q);
    CHECK(ensemble.state(3).p[0] == Approx(x[3].p[0] - k * (q + q * q * q)).epsilon(1e-14));
}

TEST_CASE("members of the stepper of a trajectory have its parameters") {
    using Many = Gauss4Kepler::Many;
    const auto x = starts<Many>(3);
    const hvi::Ensemble<Many> ensemble(x, parameters<Many>(3));
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double energy = (x[i].p[0] * x[i].p[0] + x[i].p[1] * x[i].p[1]) / 2 -
                              some(i) / std::hypot(x[i].q[0], x[i].q[1]);
        CHECK(ensemble.stepper(i).energy(x[i]) == Approx(energy).epsilon(1e-14));
    }
}

TEST_CASE("energies of eight have their parameters, and their times") {
    using Many = Gauss4Kepler::Many;
    const auto x = starts<Many>(8);
    Many stepper;
    Many::State eight;
    for (std::size_t i = 0; i < 8; ++i) {
        eight.set(i, x[i]);
        stepper.set_parameters(i, parameters_of<Many>(i));
    }
    Many::State::Lane::Row energies;
    stepper.energy(eight).store(energies);
    for (std::size_t i = 0; i < 8; ++i) {
        const double energy = (x[i].p[0] * x[i].p[0] + x[i].p[1] * x[i].p[1]) / 2 -
                              some(i) / std::hypot(x[i].q[0], x[i].q[1]);
        CHECK(energies[i] == Approx(energy).epsilon(1e-14));
    }

    using Timed = VerletSwing::Many;  // H = p^2/2 - cos(q) - sin(2*t)*q/5
    const auto y = starts<Timed>(8);
    Timed::State timed;
    for (std::size_t i = 0; i < 8; ++i) { timed.set(i, y[i]); }
    Timed().energy(timed).store(energies);
    for (std::size_t i = 0; i < 8; ++i) {
        CHECK(energies[i] == Approx(Timed().energy(y[i])).epsilon(1e-14));
    }
    CHECK(energies[0] != energies[1]);
}

TEST_CASE("there are as many parameters as starts") {
    using Many = VerletKepler::Many;
    const auto x = starts<Many>(3);
    CHECK_THROWS_AS(hvi::Ensemble<Many>(x, parameters<Many>(2)), std::invalid_argument);
    CHECK_THROWS_AS(hvi::Ensemble<Many>(x, parameters<Many>(4)), std::invalid_argument);
    CHECK_THROWS_AS(hvi::Ensemble<Many>(x, std::vector<Many::Parameters>{}), std::invalid_argument);
    hvi::Ensemble<Many> none({}, std::vector<Many::Parameters>{});
    none.advance(h, 3);
    CHECK(none.ok());
}
