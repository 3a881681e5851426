// Steppers with their stages in lanes against the same without.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include <catch2/catch.hpp>
#include <lanes/composed_lanes.hpp>
#include <lanes/composed_plain.hpp>
#include <lanes/double_pendulum_lanes.hpp>
#include <lanes/double_pendulum_plain.hpp>
#include <lanes/driven_lanes.hpp>
#include <lanes/driven_plain.hpp>
#include <lanes/fejer_lanes.hpp>
#include <lanes/fejer_plain.hpp>
#include <lanes/growing_lanes.hpp>
#include <lanes/growing_plain.hpp>
#include <lanes/grown_lanes.hpp>
#include <lanes/grown_plain.hpp>
#include <lanes/kepler_2_lanes.hpp>
#include <lanes/kepler_2_plain.hpp>
#include <lanes/kepler_3_lanes.hpp>
#include <lanes/kepler_3_plain.hpp>
#include <lanes/kepler_4_lanes.hpp>
#include <lanes/kepler_5_lanes.hpp>
#include <lanes/kepler_5_plain.hpp>
#include <lanes/kepler_8_lanes.hpp>
#include <lanes/kepler_8_plain.hpp>
#include <lanes/nonseparable_lanes.hpp>
#include <lanes/nonseparable_plain.hpp>
#include <lanes/pendulum_lanes.hpp>
#include <lanes/pendulum_plain.hpp>
#include <lanes/quartic_lanes.hpp>
#include <lanes/quartic_plain.hpp>

#include "iterations.hpp"

using namespace hvi::generated;

namespace {

/// The distance of two states over the norm of one, in units of 2^-52.
template <class A, class B>
double distance(const A& x, const B& y) {
    double difference = 0, size = 0;
    for (std::size_t k = 0; k < x.q.size(); ++k) {
        difference += std::abs(x.q[k] - y.q[k]) + std::abs(x.p[k] - y.p[k]);
        size += std::abs(x.q[k]) + std::abs(x.p[k]);
    }
    return difference / size / std::numeric_limits<double>::epsilon();
}

/// A step, ten back and forth, and how often both iterate in a hundred: in lanes at least `fewest`
/// times as often.
template <class InLanes, class Plain>
void compare(double h, double fewest = 0.95) {
    InLanes lanes;
    Plain plain;
    auto x = InLanes::initial();
    auto y = Plain::initial();
    REQUIRE(lanes.step(x, h).ok());
    REQUIRE(plain.step(y, h).ok());
    CHECK(distance(x, y) <= 4);
    long in_lanes = 0, one_by_one = 0;
    for (int i = 0; i < 100; ++i) {
        const double size = i % 7 == 6 ? -h : h;
        const auto a = lanes.step(x, size);
        const auto b = plain.step(y, size);
        REQUIRE(a.ok());
        REQUIRE(b.ok());
        in_lanes += a.iterations;
        one_by_one += b.iterations;
    }
    CHECK(distance(x, y) <= 2000);
    CHECK(static_cast<double>(in_lanes) <= 1.05 * static_cast<double>(one_by_one));
    CHECK(static_cast<double>(in_lanes) >= fewest * static_cast<double>(one_by_one));
}

}  // namespace

TEST_CASE("stages in lanes take the same step but for rounding") {
    compare<Kepler2Lanes, Kepler2Plain>(0.05);
    compare<Kepler3Lanes, Kepler3Plain>(0.1);
    compare<Kepler5Lanes, Kepler5Plain>(0.2);
    compare<Kepler8Lanes, Kepler8Plain>(0.3);
    compare<PendulumLanes, PendulumPlain>(0.3);
    compare<NonseparableLanes, NonseparablePlain>(0.1);
    compare<DoublePendulumLanes, DoublePendulumPlain>(0.1);
    compare<QuarticLanes, QuarticPlain>(0.2);
    compare<FejerLanes, FejerPlain>(0.1);
}

TEST_CASE("the stages of a driven system have their times in lanes") {
    DrivenLanes lanes;
    DrivenPlain plain;
    auto x = DrivenLanes::State{{{{0.5, -0.25}}, {{0.0, 1.0}}}, 0.75};
    auto y = DrivenPlain::State{{{{0.5, -0.25}}, {{0.0, 1.0}}}, 0.75};
    for (int i = 0; i < 20; ++i) {
        REQUIRE(lanes.step(x, 0.2).ok());
        REQUIRE(plain.step(y, 0.2).ok());
    }
    CHECK(x.t == y.t);
    CHECK(distance(x, y) <= 100);
}

TEST_CASE("so have those of a driven system that is not separable") {
    GrowingLanes lanes;
    GrowingPlain plain;
    auto x = GrowingLanes::State{{{{0.5}}, {{1.0}}}, 0.75};
    auto y = GrowingPlain::State{{{{0.5}}, {{1.0}}}, 0.75};
    for (int i = 0; i < 20; ++i) {
        REQUIRE(lanes.step(x, 0.2).ok());
        REQUIRE(plain.step(y, 0.2).ok());
    }
    CHECK(distance(x, y) <= 200);
    // H = (1 + t/4) K: where t is, q and p are as without it at the time t + t^2/8.
    NonseparablePlain without;
    auto z = NonseparablePlain::State{{{0.5}}, {{1.0}}};
    const double time = (x.t + x.t * x.t / 8) - (0.75 + 0.75 * 0.75 / 8);
    for (int i = 0; i < 500; ++i) { REQUIRE(without.step(z, time / 500).ok()); }
    CHECK(x.q[0] == Approx(z.q[0]).epsilon(1e-4));
    CHECK(x.p[0] == Approx(z.p[0]).epsilon(1e-4));
}

TEST_CASE("compositions take their steps in lanes one after the other") {
    compare<ComposedLanes, ComposedPlain>(0.2, 0.5);
    GrownLanes lanes;
    GrownPlain plain;
    auto x = GrownLanes::State{{{{0.5}}, {{1.0}}}, 0.75};
    auto y = GrownPlain::State{{{{0.5}}, {{1.0}}}, 0.75};
    for (int i = 0; i < 20; ++i) {
        REQUIRE(lanes.step(x, 0.2).ok());
        REQUIRE(plain.step(y, 0.2).ok());
    }
    CHECK(x.t == Approx(y.t).epsilon(1e-15));
    CHECK(distance(x, y) <= 200);
}

TEST_CASE("steps in a row begin with slopes of those before, though they differ in size") {
    // Yoshida's solution A of order 6.
    constexpr double w1 = -1.17767998417887100695, w2 = 0.23557321335935813368,
                     w3 = 0.78451361047755726382, w0 = 1 - 2 * (w1 + w2 + w3);
    constexpr double h = 0.1;
    ComposedLanes composed;
    Kepler4Lanes alone;
    auto x = ComposedLanes::initial();
    auto y = Kepler4Lanes::initial();
    int iterations = 0, iterations_alone = 0;
    for (int i = 0; i < 200; ++i) {
        const hvi::Status status = composed.step(x, h);
        REQUIRE(status.ok());
        iterations += status.iterations;
        for (const double w : {w3, w2, w1, w0, w1, w2, w3}) {
            alone.reset();
            const hvi::Status of_part = alone.step(y, w * h);
            REQUIRE(of_part.ok());
            iterations_alone += of_part.iterations;
        }
    }
    CHECK(iterations < 0.75 * iterations_alone);
    CHECK(distance(x, y) <= 10000);  // remainders of sums are forgotten with the slopes
}

TEST_CASE("a composition of which one step fails leaves the state where it was") {
    ComposedLanes stepper;
    auto x = ComposedLanes::initial();
    auto y = x, fresh = x;
    constexpr int most_of_newton = 60;
    const hvi::Status failed = stepper.step(y, 1.85);
    CHECK(failed.code() == hvi::Status::Code::not_converged);
    CHECK(failed.iterations > most_of_newton);  // of those before the one that failed, too
    CHECK(y.q == x.q);
    CHECK(y.p == x.p);
    REQUIRE(stepper.step(x, 0.2).ok());
    REQUIRE(ComposedLanes().step(fresh, 0.2).ok());
    CHECK(distance(x, fresh) <= 4);
}

TEST_CASE("where fixed points do not contract, Newton's method finds the stages in lanes") {
    PendulumLanes lanes;
    PendulumPlain plain;
    auto x = PendulumLanes::State{{{0.3}}, {{0.1}}};
    auto y = PendulumPlain::State{{{0.3}}, {{0.1}}};
    // h omega = 8, and fixed points contract up to 4.
    REQUIRE(lanes.step(x, 8).ok());
    REQUIRE(plain.step(y, 8).ok());
    CHECK(distance(x, y) <= 100);
    QuarticLanes pairs;
    QuarticPlain plain_pairs;
    auto u = QuarticLanes::State{{{1.0}}, {{2.0}}};
    auto v = QuarticPlain::State{{{1.0}}, {{2.0}}};
    REQUIRE(pairs.step(u, 0.6).ok());
    REQUIRE(plain_pairs.step(v, 0.6).ok());
    CHECK(distance(u, v) <= 100);
    NonseparableLanes mixed;
    NonseparablePlain plain_mixed;
    auto w = NonseparableLanes::State{{{0.3}}, {{0.1}}};
    auto z = NonseparablePlain::State{{{0.3}}, {{0.1}}};
    REQUIRE(mixed.step(w, 6).ok());
    REQUIRE(plain_mixed.step(z, 6).ok());
    CHECK(distance(w, z) <= 100);
}

TEST_CASE(
    "a step in lanes that fails leaves the state, and the next one is that of a new stepper") {
    Kepler5Lanes stepper;
    auto x = Kepler5Lanes::initial();
    REQUIRE(stepper.step(x, 0.1).ok());
    const auto before = x;
    auto nowhere = x;
    nowhere.q = {0.0, 0.0};
    nowhere.p = {0.0, 0.0};
    CHECK_FALSE(stepper.step(nowhere, 0.1).ok());
    CHECK(nowhere.q[0] == 0.0);
    Kepler5Lanes fresh;
    auto y = before;
    REQUIRE(stepper.step(x, 0.1).ok());
    REQUIRE(fresh.step(y, 0.1).ok());
    CHECK(x.q == y.q);
    CHECK(x.p == y.p);
}

TEMPLATE_TEST_CASE("what two steps left is forgotten with the state, and with the size of the step",
                   "", Kepler2Lanes, Kepler2Plain, Kepler3Lanes, Kepler3Plain, ComposedLanes) {
    TestType stepper;
    auto x = TestType::initial();
    for (int i = 0; i < 5; ++i) { REQUIRE(stepper.step(x, 0.05).ok()); }
    x.q[0] += 0.25;
    TestType fresh;
    auto y = x;
    const auto same = [&](double h) {
        REQUIRE(stepper.step(x, h).ok());
        REQUIRE(fresh.step(y, h).ok());
        CHECK(x.q == y.q);
        CHECK(x.p == y.p);
    };
    for (const double h : {0.05, 0.05, 0.05, 0.05, 0.04, 0.05, 0.05, 0.05}) { same(h); }
    // A step that fails is none of the two either.
    auto nowhere = x;
    nowhere.q = {0.0, 0.0};
    nowhere.p = {0.0, 0.0};
    CHECK_FALSE(stepper.step(nowhere, 0.05).ok());
    fresh.reset();
    for (int i = 0; i < 4; ++i) { same(0.05); }
}

TEST_CASE("iterations do not depend on the machine") {
    // The numbers are from a program written by hand for these methods, with equal starting values
    // and ends of iterations: 6.43 and 4.91 a step on Kepler's problem; where starting values come
    // from two steps 4.20 and 6.95; for four stages, by least squares, 6.55 on the pendulum, and
    // 11.68 where both slopes come from equal Q and P, to which a nudge adds three quarters.
    const double orbit = 8 * std::atan(1.0);
    CHECK(iterations(Kepler8Lanes{}, Kepler8Lanes::initial(), orbit / 20, 2000) ==
          Approx(6.43).margin(0.1));
    CHECK(iterations(Kepler8Plain{}, Kepler8Plain::initial(), orbit / 20, 2000) ==
          Approx(6.43).margin(0.1));
    CHECK(iterations(Kepler8Lanes{}, Kepler8Lanes::initial(), orbit / 40, 4000) ==
          Approx(4.91).margin(0.1));
    CHECK(iterations(PendulumLanes{}, PendulumLanes::State{{{1.5}}, {{0.0}}}, 0.4, 2500) ==
          Approx(6.55).margin(0.1));
    CHECK(iterations(Kepler2Lanes{}, Kepler2Lanes::initial(), 0.02, 2000) ==
          Approx(4.20).margin(0.05));
    CHECK(iterations(Kepler2Plain{}, Kepler2Plain::initial(), 0.02, 2000) ==
          Approx(4.20).margin(0.05));
    CHECK(iterations(Kepler3Lanes{}, Kepler3Lanes::initial(), 0.2, 2000) ==
          Approx(6.95).margin(0.05));
    CHECK(iterations(NonseparableLanes{}, NonseparableLanes::initial(), 0.1, 2830) ==
          Approx(11.68 + 0.75).margin(0.1));
    CHECK(iterations(NonseparablePlain{}, NonseparablePlain::initial(), 0.1, 2830) ==
          Approx(11.68 + 0.75).margin(0.1));
}
