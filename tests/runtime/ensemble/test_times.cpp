// H that depends on the time: each trajectory has its own.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

#include "steppers.hpp"

using namespace ensemble_test;
using Code = hvi::Status::Code;

namespace {

/// q'' = cos(2t), from x at its time: at the time t.
template <class State>
double pushed(const State& x, double t) {
    const double rest = x.p[0] - std::sin(2 * x.t) / 2;
    return x.q[0] + rest * (t - x.t) - (std::cos(2 * t) - std::cos(2 * x.t)) / 4;
}

/// The largest distance from that after the time 5.
template <class Pair>
double error(int steps) {
    using Many = typename Pair::Many;
    const auto x = starts<Many>(11);
    hvi::Ensemble<Many> ensemble(x);
    ensemble.advance(5.0 / steps, steps);
    REQUIRE(ensemble.ok());
    double worst = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const auto y = ensemble.state(i);
        worst = std::fmax(worst, std::abs(y.q[0] - pushed(x[i], y.t)));
    }
    return worst;
}

}  // namespace

TEMPLATE_TEST_CASE("times are summed as exactly as that of one trajectory", "", HVI_TIMED_PAIRS) {
    using Many = typename TestType::Many;
    constexpr double h = 0.01;
    constexpr int steps = 2000;
    const auto x = starts<Many>(9);
    hvi::Ensemble<Many> ensemble(x);
    ensemble.advance(h, steps / 2);
    ensemble.advance(h, steps - steps / 2);
    REQUIRE(ensemble.ok());
    bool all_are_plain = true;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const long double t = static_cast<long double>(x[i].t) + 2000 * static_cast<long double>(h);
        CHECK(ensemble.state(i).t == static_cast<double>(t));
        double plain = x[i].t;
        for (int step = 0; step < steps; ++step) { plain += h; }
        all_are_plain = all_are_plain && ensemble.state(i).t == plain;
    }
    CHECK_FALSE(all_are_plain);
}

TEST_CASE("where a push is known, each trajectory follows that of its own time") {
    CHECK(std::log2(error<KahanLiPushed>(8) / error<KahanLiPushed>(16)) == Approx(8).margin(0.8));
    CHECK(error<KahanLiPushed>(200) < 1e-14);
    CHECK(std::log2(error<Gauss5Pushed>(3) / error<Gauss5Pushed>(6)) == Approx(10).margin(1));
    CHECK(error<Gauss5Pushed>(60) < 1e-14);
}

TEMPLATE_TEST_CASE("H = (1 + t/4) f(K) goes where K goes in the time f'(K) (t + t^2/8)", "",
                   made::Gauss3Growings, made::Gauss3GrowingRoots) {
    const auto x = starts<TestType>(9);
    hvi::Ensemble<TestType> ensemble(x);
    ensemble.advance(0.01, 100);
    REQUIRE(ensemble.ok());
    for (std::size_t i = 0; i < x.size(); ++i) {
        const auto y = ensemble.state(i);
        double time = (y.t + y.t * y.t / 8) - (x[i].t + x[i].t * x[i].t / 8);
        if (std::is_same_v<TestType, made::Gauss3GrowingRoots>) {  // f = sqrt(2 K)
            time /= std::sqrt((x[i].q[0] * x[i].q[0] + 1) * (x[i].p[0] * x[i].p[0] + 1));
        }
        made::Gauss3Nonseparable without;
        made::Gauss3Nonseparable::State z{x[i].q, x[i].p};
        for (int step = 0; step < 500; ++step) { REQUIRE(without.step(z, time / 500).ok()); }
        CHECK(std::abs(y.q[0] - z.q[0]) < 1e-8);
        CHECK(std::abs(y.p[0] - z.p[0]) < 1e-8);
    }
}

TEST_CASE("an energy is that of the time") {
    auto x = made::VerletSwings::initial();
    x.t = 0.75;
    const made::VerletSwings stepper;
    CHECK(stepper.energy(x) ==
          Approx(x.p[0] * x.p[0] / 2 - (1 + std::sin(1.5) / 4) * std::cos(x.q[0])));
}

TEMPLATE_TEST_CASE("a time that is no number stops its trajectory alone", "", HVI_TIMED_PAIRS) {
    using Many = typename TestType::Many;
    for (const double t :
         {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
        auto x = starts<Many>(8);
        hvi::Ensemble<Many> without(x);
        x[2].t = t;
        hvi::Ensemble<Many> ensemble(x);
        ensemble.advance(0.05, 10);
        without.advance(0.05, 10);
        CHECK(ensemble.status(2).code() == Code::not_finite);
        CHECK(ensemble.steps(2) == 0);
        CHECK(same_bits(ensemble.state(2), x[2]));
        for (const std::size_t i : {0U, 1U, 3U, 7U}) {
            CHECK(same_bits(ensemble.state(i), without.state(i)));
        }
    }
}

TEMPLATE_TEST_CASE("one that stops keeps its time", "", VerletSwing, Gauss3Swing) {
    using Many = typename TestType::Many;
    auto x = starts<Many>(8);
    x[5].p[0] = std::numeric_limits<double>::quiet_NaN();
    hvi::Ensemble<Many> ensemble(x);
    ensemble.advance(0.05, 10);
    CHECK(ensemble.state(5).t == x[5].t);
    CHECK(ensemble.state(4).t > x[4].t);
}

TEMPLATE_TEST_CASE("the same states at another time are those of a fresh stepper", "",
                   HVI_TIMED_PAIRS) {
    using Many = typename TestType::Many;
    constexpr double h = 0.05;
    Many used, fresh;
    typename Many::State state, other;
    const auto x = starts<Many>(8);
    for (std::size_t i = 0; i < 8; ++i) { state.set(i, x[i]); }
    for (int step = 0; step < 5; ++step) { REQUIRE(used.step(state, h).ok()); }
    for (std::size_t i = 0; i < 8; ++i) {
        auto moved = state[i];
        moved.t += 1;
        state.set(i, moved);
        other.set(i, moved);
    }
    for (int step = 0; step < 5; ++step) {
        REQUIRE(used.step(state, h).ok());
        REQUIRE(fresh.step(other, h).ok());
        for (std::size_t i = 0; i < 8; ++i) {
            CHECK(same_bits(state[i], other[i]));
            CHECK(state.status()[i].iterations == other.status()[i].iterations);
        }
    }
}
