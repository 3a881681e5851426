// Trajectories that somebody watches on their way.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <cstdint>
#include <limits>

#include <catch2/catch.hpp>

#include "steppers.hpp"

using namespace ensemble_test;

namespace {

constexpr double h = 1.0 / 32;

/// Counts of calls, and largest positions, of each trajectory.
struct Seen {
    std::vector<std::int64_t> calls;
    std::vector<double> largest;  ///< q[0] after a step

    explicit Seen(std::size_t count) : calls(count), largest(count, -HUGE_VAL) {}

    template <class State>
    void operator()(std::size_t i, const State& x) {
        ++calls[i];
        largest[i] = std::fmax(largest[i], x.q[0]);
    }
};

}  // namespace

TEMPLATE_TEST_CASE("each step is seen, and changes nothing", "", VerletPendulum, KahanLiKepler,
                   Gauss4Kepler, Gauss3Nonseparable, Gauss3Swing) {
    using Many = typename TestType::Many;
    const auto x = starts<Many>(21);
    std::vector<double> sizes;
    std::vector<std::int64_t> steps;
    for (std::size_t i = 0; i < x.size(); ++i) {
        sizes.push_back(i % 4 == 3 ? -h : h);
        steps.push_back(static_cast<std::int64_t>(i * 7 % 30));
    }
    for (const unsigned threads : {1U, 3U}) {
        Seen seen(x.size());
        hvi::Ensemble<Many> watched(x), plain(x);
        watched.advance_watched(
            sizes, steps,
            [&](std::size_t i, const auto& at) {
                seen(i, at);
                return true;
            },
            threads);
        plain.advance(sizes, steps, threads);
        for (std::size_t i = 0; i < x.size(); ++i) {
            CHECK(same_bits(watched.state(i), plain.state(i)));
            CHECK(watched.steps(i) == steps[i]);
            CHECK(seen.calls[i] == steps[i]);
            // One step after the other gives the same largest value.
            hvi::Ensemble<Many> alone({x[i]});
            double largest = -HUGE_VAL;
            for (std::int64_t step = 0; step < steps[i]; ++step) {
                alone.advance(sizes[i], 1);
                largest = std::fmax(largest, alone.state(0).q[0]);
            }
            if (steps[i] > 0) { CHECK(seen.largest[i] == Approx(largest).epsilon(1e-13)); }
        }
    }
}

TEMPLATE_TEST_CASE("a trajectory ends where its watcher says so, and goes on from there", "",
                   VerletPendulum, KahanLiKepler, Gauss4Kepler, Gauss3Swing) {
    using Many = typename TestType::Many;
    const auto x = starts<Many>(19);
    const auto last_of = [](std::size_t i) { return static_cast<std::int64_t>(3 + i * 5 % 17); };
    std::vector<std::int64_t> calls(x.size());
    hvi::Ensemble<Many> ensemble(x);
    ensemble.advance_watched(
        h, 40, [&](std::size_t i, const auto&) { return ++calls[i] < last_of(i) || i % 6 == 5; });
    for (std::size_t i = 0; i < x.size(); ++i) {
        const std::int64_t steps = i % 6 == 5 ? 40 : last_of(i);
        hvi::Ensemble<Many> alone({x[i]});
        alone.advance(h, steps);
        CHECK(ensemble.status(i).ok());
        CHECK(ensemble.steps(i) == steps);
        CHECK(calls[i] == steps);
        CHECK(same_bits(ensemble.state(i), alone.state(0)));
    }
    ensemble.advance(h, 10);
    for (std::size_t i = 0; i < x.size(); ++i) {
        hvi::Ensemble<Many> alone({x[i]});
        alone.advance(h, i % 6 == 5 ? 40 : last_of(i));
        alone.advance(h, 10);
        CHECK(same_bits(ensemble.state(i), alone.state(0)));
    }
}

TEST_CASE("a step that fails is not seen") {
    using Many = VerletKepler::Many;
    auto x = starts<Many>(10);
    x[4].p[0] = std::numeric_limits<double>::quiet_NaN();
    std::vector<std::int64_t> calls(x.size());
    hvi::Ensemble<Many> ensemble(x);
    ensemble.advance_watched(h, 12, [&](std::size_t i, const auto&) { return ++calls[i] > 0; });
    for (std::size_t i = 0; i < x.size(); ++i) { CHECK(calls[i] == (i == 4 ? 0 : 12)); }
    CHECK_FALSE(ensemble.status(4).ok());
}

TEST_CASE("steppers of one trajectory are watched, too") {
    using One = VerletPendulum::One;
    const std::vector<One::State> x(5, One::initial());
    hvi::Ensemble<One> ensemble(x), plain(x);
    std::vector<std::int64_t> calls(x.size());
    ensemble.advance_watched(h, 20, [&](std::size_t i, const One::State&) {
        return ++calls[i] < static_cast<std::int64_t>(4 * i + 2);
    });
    for (std::size_t i = 0; i < x.size(); ++i) {
        One stepper;
        One::State y = x[i];
        const auto steps = static_cast<std::int64_t>(4 * i + 2);
        for (std::int64_t step = 0; step < steps; ++step) { REQUIRE(stepper.step(y, h).ok()); }
        CHECK(ensemble.steps(i) == steps);
        CHECK(same_bits(ensemble.state(i), y));
    }
}
