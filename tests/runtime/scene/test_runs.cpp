// Many steps: hvi::integrate and Boost.Odeint.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <functional>
#include <vector>

#include <boost/numeric/odeint/integrate/integrate_const.hpp>
#include <catch2/catch.hpp>
#include <hvi/integrate.hpp>
#include <hvi/odeint.hpp>

#include "scenes.hpp"

using namespace hvi::generated;

TEST_CASE("a run with an observer") {
    Pendulum stepper;
    Pendulum::State x = Pendulum::initial();
    std::vector<double> times;
    double sum = 0.0;
    const hvi::Run run = hvi::integrate(stepper, x, 1.0, 0.1, 20, [&](const auto& state, double t) {
        times.push_back(t);
        sum += state.q[0];
    });
    REQUIRE(run.ok());
    CHECK(run.steps == 20);
    CHECK(run.iterations > 20);
    REQUIRE(times.size() == 21);
    CHECK(times.front() == 1.0);
    CHECK(times.back() == 1.0 + 20 * 0.1);

    Pendulum other;
    Pendulum::State y = Pendulum::initial();
    double expected = y.q[0];
    for (int i = 0; i < 20; ++i) {
        REQUIRE(other.step(y, 0.1).ok());
        expected += y.q[0];
    }
    CHECK(scenes::same_bits(x, y));
    CHECK(sum == expected);
}

TEST_CASE("a run that fails keeps the last good state") {
    Nonseparable stepper;
    Nonseparable::State x = Nonseparable::initial();
    const hvi::Run run = hvi::integrate(stepper, x, 0.0, 1.0, 5);
    CHECK_FALSE(run.ok());
    CHECK(run.steps == 0);
    CHECK(scenes::same_bits(x, Nonseparable::initial()));
}

TEST_CASE("Boost.Odeint takes our steps") {
    namespace odeint = boost::numeric::odeint;
    Kepler::State x = Kepler::initial();
    std::size_t seen = 0;
    const std::size_t steps =
        odeint::integrate_const(hvi::Odeint<Kepler>(), hvi::no_system, x, 0.0, 5.0, 0.05,
                                [&](const Kepler::State&, double) { ++seen; });
    CHECK(steps >= 99);  // Odeint adds up the times
    CHECK(seen == steps + 1);

    Kepler stepper;
    Kepler::State y = Kepler::initial();
    for (std::size_t i = 0; i < steps; ++i) { REQUIRE(stepper.step(y, 0.05).ok()); }
    CHECK(scenes::same_bits(x, y));

    Kepler::State at_sun{{0.0, 0.0}, {0.0, 0.0}};
    CHECK_THROWS_AS(
        odeint::integrate_const(hvi::Odeint<Kepler>(), hvi::no_system, at_sun, 0.0, 5.0, 0.05),
        hvi::StepFailure);
    CHECK(scenes::same_bits(at_sun, Kepler::State{}));
}
