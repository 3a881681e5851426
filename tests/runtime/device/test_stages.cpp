// Stages of threads, iterated by fixed points.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "steppers.hpp"

using namespace device_test;

namespace {

constexpr double step_size = 1.0 / 32;

/// Returns the states after so many steps.
template <class Threads>
std::vector<typename Threads::State> after(std::vector<typename Threads::State> x, double h,
                                           int steps) {
    const auto same = parameters<Threads>(x.size());
    hvi::device::advance<Threads>(x.data(), same.data(), x.size(), h, steps);
    return x;
}

/// Returns the state as one of an ensemble.
template <class Lanes, class State>
typename Lanes::Trajectory in_lanes(const State& x) {
    typename Lanes::Trajectory result;
    result.q[0] = x.q[0];
    result.p[0] = x.p[0];
    if constexpr (HasTime<State>::value) { result.t = x.t; }
    return result;
}

}  // namespace

/// NOTE: they take the same sums in the same order, and H calls no function.
TEMPLATE_TEST_CASE("stages of threads have the bits of ensembles in lanes", "",
                   HVI_PAIRS_WITH_LANES) {
    using Threads = typename TestType::Threads;
    using Lanes = typename TestType::One;
    const auto x = starts<Threads>(40);
    const auto ends = after<Threads>(x, step_size, 200);
    std::vector<typename Lanes::Trajectory> starts_in_lanes;
    for (const auto& each : x) { starts_in_lanes.push_back(in_lanes<Lanes>(each)); }
    hvi::Ensemble<Lanes> ensemble(starts_in_lanes);
    ensemble.advance(step_size, 200, 1);
    for (std::size_t i = 0; i < x.size(); ++i) {
        REQUIRE(ends[i].steps == 200);
        CHECK(distance(ends[i], ensemble.state(i)) == 0);
        CHECK(ends[i].iterations == ensemble.status(i).iterations);
    }
}

/// NOTE: steppers of one trajectory solve for positions alone, in other sums.
TEMPLATE_TEST_CASE("stages of threads are near those of a trajectory", "", HVI_PAIRS_OF_STAGES) {
    using Threads = typename TestType::Threads;
    const auto x = starts<Threads>(20);
    for (const int steps : {1, 500}) {
        const auto ends = after<Threads>(x, step_size, steps);
        double worst = 0;
        for (std::size_t i = 0; i < x.size(); ++i) {
            REQUIRE(ends[i].steps == steps);
            typename TestType::One stepper;
            auto y = alone<typename TestType::One>(x[i]);
            for (int step = 0; step < steps; ++step) { REQUIRE(stepper.step(y, step_size).ok()); }
            worst = std::fmax(worst, distance(ends[i], y));
        }
        CHECK(worst <= (steps == 1 ? 4 : 1e4));
    }
}

/// NOTE: at this h the error of the method is below rounding. Were the sums of 200 000 steps not
/// compensated, each step would add a rounding of about 1e-16.
TEST_CASE("the energy of threads does not drift") {
    using Threads = made::Gauss3NonseparableThreads;
    const Threads stepper{Threads::Parameters()};
    const auto x = starts<Threads>(4);
    const auto last = after<Threads>(x, 0x1p-8, 200'000);
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double energy = stepper.energy(x[i]);
        CHECK(std::abs(stepper.energy(last[i]) / energy - 1) < 1e-14);
        CHECK(last[i].steps == 200'000);
    }
}

TEST_CASE("threads whose stages have no solution nearby stop and keep their state") {
    using Threads = made::Gauss3NonseparableThreads;
    auto x = starts<Threads>(3);
    x[1].q[0] = 40;  // it turns a hundred times as fast
    x[1].p[0] = 40;
    const auto end = after<Threads>(x, 0.125, 20);
    CHECK(end[1].status == hvi::Status::Code::not_converged);
    CHECK(end[1].steps == 0);
    CHECK(end[1].iterations > 2);
    CHECK(end[1].iterations <= hvi::device::most_sweeps);
    CHECK(end[1].q[0] == 40);
    CHECK(end[1].p[0] == 40);
    CHECK(end[0].steps == 20);
    CHECK(end[2].steps == 20);
}

TEST_CASE("steps of threads of another size begin anew, and back lead back") {
    using Threads = made::Gauss4KeplerThreads;
    const auto x = starts<Threads>(5);
    const auto there = after<Threads>(x, step_size, 100);
    const auto back = after<Threads>(there, -step_size, 100);
    for (std::size_t i = 0; i < x.size(); ++i) {
        CHECK(back[i].steps == 200);
        CHECK(distance(back[i], x[i]) < 100);
    }
}
