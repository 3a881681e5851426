// Steppers of scenes in __float128, against exact solutions.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>

#include <catch2/catch.hpp>
#include <wide/driven.hpp>
#include <wide/fitted.hpp>
#include <wide/iterated_oscillator.hpp>
#include <wide/kepler.hpp>
#include <wide/newton_kepler.hpp>
#include <wide/newton_nonseparable.hpp>
#include <wide/nonseparable.hpp>
#include <wide/oscillator.hpp>
#include <wide/pendulum.hpp>
#include <wide/qp.hpp>
#include <wide/springs.hpp>
#include <wide/taylor_kepler.hpp>
#include <wide/trig3_nonseparable.hpp>
#include <wide/verlet_pendulum.hpp>

#include "numbers.hpp"

using namespace hvi::generated;
using namespace float128;

namespace {

/// Returns the periods from the starts of the scenes. The pendulum has the period 4 K(sin(q/2)),
/// (q^2 + 1)(p^2 + 1)/2 = 5 has 4 K(3/sqrt(10))/sqrt(10), and K(k) = pi/(2 mean(1, sqrt(1 - k^2))).
Widest period_of_kepler() { return 2 * pi(); }
Widest period_of_pendulum() { return 2 * pi() / mean(1, hvi::math::cos(ratio(3, 4))); }
Widest period_of_nonseparable() { return 2 * pi() / mean(hvi::math::sqrt(Widest(10)), 1); }

/// Where steps that are parts of one period end: how far from where they began.
template <class Stepper>
Widest return_error(Widest period, int steps) {
    Stepper stepper;
    typename Stepper::State x = Stepper::initial();
    for (int i = 0; i < steps; ++i) {
        if (!stepper.step(x, period / Widest(steps)).ok()) { return hvi::detail::infinity<Widest>; }
    }
    return distance(x, Stepper::initial());
}

/// The largest change of the energy.
template <class Stepper>
Widest energy_error(Widest h, int steps) {
    Stepper stepper;
    typename Stepper::State x = Stepper::initial();
    const Widest start = stepper.energy(x);
    Widest error = 0;
    for (int i = 0; i < steps; ++i) {
        if (!stepper.step(x, h).ok()) { return hvi::detail::infinity<Widest>; }
        error = hvi::detail::larger(error, hvi::detail::abs(stepper.energy(x) - start));
    }
    return error;
}

template <class Stepper>
void check_oscillator(Stepper stepper) {
    typename Stepper::State x = Stepper::initial();
    for (int i = 1; i <= 320; ++i) {
        REQUIRE(stepper.step(x, ratio(1, 32)).ok());
        const Widest t = ratio(i, 32);
        REQUIRE(near(x.q[0], hvi::math::cos(t), 64 * eps));
        REQUIRE(near(x.p[0], -hvi::math::sin(t), 64 * eps));
    }
}

}  // namespace

TEST_CASE("the oscillator is at cos(t)") {
    check_oscillator(BasicWideOscillator<Widest>());
    check_oscillator(BasicWideIteratedOscillator<Widest>());
}

TEST_CASE("two coupled oscillators, of the frequencies 1 and sqrt(3)") {
    BasicWideSprings<Widest> stepper;
    BasicWideSprings<Widest>::State x{{Widest(1), Widest(0)}, {Widest(0), Widest(0)}};
    const Widest root = hvi::math::sqrt(Widest(3));
    for (int i = 1; i <= 320; ++i) {
        REQUIRE(stepper.step(x, ratio(1, 32)).ok());
        const Widest slow = hvi::math::cos(ratio(i, 32));
        const Widest fast = hvi::math::cos(root * ratio(i, 32));
        REQUIRE(near(x.q[0], (slow + fast) / 2, 64 * eps));
        REQUIRE(near(x.q[1], (slow - fast) / 2, 64 * eps));
    }
}

TEST_CASE("q p, whose step is no product of shears") {
    BasicWideQp<Widest> stepper;
    auto x = BasicWideQp<Widest>::initial();
    const auto start = x;
    for (int i = 1; i <= 64; ++i) {
        REQUIRE(stepper.step(x, ratio(1, 32)).ok());
        const Widest growth = hvi::math::exp(ratio(i, 32));
        REQUIRE(near(x.q[0], start.q[0] * growth, 64 * eps * growth));
        REQUIRE(near(x.p[0], start.p[0] / growth, 64 * eps));
    }
}

TEST_CASE("a method of a parameter, which it takes in __float128") {
    const Widest h = ratio(1, 4);
    BasicWideFitted<Widest> stepper({}, h);
    BasicWideFitted<long double> other({}, 0.25L);
    REQUIRE(stepper.status().ok());
    auto x = BasicWideFitted<Widest>::initial();
    auto y = BasicWideFitted<long double>::initial();
    for (int i = 0; i < 40; ++i) {
        REQUIRE(stepper.step(x, h).ok());
        REQUIRE(other.step(y, 0.25L).ok());
        REQUIRE(near(x.q[0], y.q[0], 64 * eps_of_long_double));
    }
    for (int i = 0; i < 40; ++i) { REQUIRE(stepper.step(x, -h).ok()); }
    CHECK(at_most(distance(x, BasicWideFitted<Widest>::initial()), 64 * eps));
}

TEST_CASE("closed orbits close") {
    constexpr Widest bound = 1000 * eps;  // in __float128 1.9e-31
    CHECK(at_most(return_error<BasicWideKepler<Widest>>(period_of_kepler(), 600), bound));
    CHECK(at_most(return_error<BasicWideNewtonKepler<Widest>>(period_of_kepler(), 600), bound));
    CHECK(at_most(return_error<BasicWideTaylorKepler<Widest>>(period_of_kepler(), 600), bound));
    CHECK(at_most(return_error<BasicWidePendulum<Widest>>(period_of_pendulum(), 200), bound));
    CHECK(
        at_most(return_error<BasicWideNonseparable<Widest>>(period_of_nonseparable(), 400), bound));
    CHECK(at_most(return_error<BasicWideNewtonNonseparable<Widest>>(period_of_nonseparable(), 400),
                  bound));
}

TEST_CASE("gauss:8 is of order 16") {
    if (!is_quad) { return; }
    const auto check = [](Widest coarse, Widest fine) {
        CHECK(std::log2(static_cast<double>(coarse / fine)) == Approx(16.0).margin(0.25));
    };
    check(return_error<BasicWidePendulum<Widest>>(period_of_pendulum(), 40),
          return_error<BasicWidePendulum<Widest>>(period_of_pendulum(), 80));
    check(return_error<BasicWideNonseparable<Widest>>(period_of_nonseparable(), 50),
          return_error<BasicWideNonseparable<Widest>>(period_of_nonseparable(), 100));
}

TEST_CASE("the energy stays") {
    constexpr Widest bound = 64 * eps;  // in __float128 1.2e-32
    CHECK(at_most(energy_error<BasicWideKepler<Widest>>(ratio(1, 100), 1000), bound));
    CHECK(at_most(energy_error<BasicWideNewtonKepler<Widest>>(ratio(1, 100), 200), bound));
    CHECK(at_most(energy_error<BasicWidePendulum<Widest>>(ratio(1, 32), 1000), bound));
    CHECK(at_most(energy_error<BasicWideNonseparable<Widest>>(ratio(1, 256), 400), bound));
    CHECK(at_most(energy_error<BasicWideOscillator<Widest>>(ratio(1, 10), 10'000), bound));
}

TEST_CASE("H may depend on the time") {
    // q'' = -q + cos(t/2) has the solution 4/3 cos(t/2).
    BasicWideDriven<Widest> stepper;
    BasicWideDriven<Widest>::State x{{{ratio(4, 3)}, {Widest(0)}}, Widest(0)};
    for (int i = 1; i <= 320; ++i) {
        REQUIRE(stepper.step(x, ratio(1, 32)).ok());
        REQUIRE(x.t == ratio(i, 32));
        REQUIRE(near(x.q[0], 4 * hvi::math::cos(x.t / 2) / 3, 64 * eps));
        REQUIRE(near(x.p[0], -2 * hvi::math::sin(x.t / 2) / 3, 64 * eps));
    }
}

TEST_CASE("explicit steps") {
    BasicWideVerletPendulum<Widest> stepper;
    auto x = BasicWideVerletPendulum<Widest>::initial();
    const Widest h = ratio(1, 10);
    Widest q = x.q[0], p = x.p[0];
    for (int i = 0; i < 10; ++i) {
        REQUIRE(stepper.step(x, h).ok());
        const Widest middle = p - h / 2 * hvi::math::sin(q);
        q += h * middle;
        p = middle - h / 2 * hvi::math::sin(q);
    }
    CHECK(near(x.q[0], q, 64 * eps));
    CHECK(near(x.p[0], p, 64 * eps));
}

TEST_CASE("the curve of a step") {
    using Stepper = BasicWideTrig3Nonseparable<Widest>;
    Stepper stepper;
    const Widest nowhere = stepper.position(ratio(1, 2))[0];
    CHECK(nowhere != nowhere);
    Stepper::State x = Stepper::initial();
    REQUIRE(stepper.step(x, ratio(1, 50)).ok());
    CHECK(near(stepper.position(0)[0], -3, 16 * eps));
    CHECK(near(stepper.position(1)[0], x.q[0], 16 * eps));
    BasicWideTrig3Nonseparable<long double> other;
    auto y = BasicWideTrig3Nonseparable<long double>::initial();
    REQUIRE(other.step(y, 1.0L / 50).ok());
    const long double middle = other.position(0.5L)[0];
    CHECK(near(stepper.position(ratio(1, 2))[0], middle, 64 * eps_of_long_double));
}

TEST_CASE("steps that fail, and steps after a state was edited") {
    using Stepper = BasicWideOscillator<Widest>;
    Stepper stepper;
    Stepper::State x = Stepper::initial();
    REQUIRE(stepper.step(x, ratio(1, 10)).ok());
    const Stepper::State before = x;
    CHECK_FALSE(stepper.step(x, hvi::detail::infinity<Widest>).ok());
    CHECK(x.q[0] == before.q[0]);
    CHECK(x.p[0] == before.p[0]);
    x.q[0] += 2 * eps;
    Stepper::State fresh = x;
    REQUIRE(stepper.step(x, ratio(1, 10)).ok());
    REQUIRE(Stepper().step(fresh, ratio(1, 10)).ok());
    CHECK(x.q[0] == fresh.q[0]);
    CHECK(x.p[0] == fresh.p[0]);
    stepper.reset();
    Stepper::State at_rest{{Widest(0)}, {Widest(0)}};
    REQUIRE(stepper.step(at_rest, ratio(1, 10)).ok());
    CHECK(at_rest.q[0] == 0);
    CHECK(at_rest.p[0] == 0);
    Stepper::State lost{{Widest(1)}, {hvi::detail::infinity<Widest>}};
    CHECK_FALSE(stepper.step(lost, ratio(1, 10)).ok());
}
