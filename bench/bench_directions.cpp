// The cost of directions that steps carry along: a table of the time of n of them with their step,
// in steps without any.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <ctime>
#include <vector>

#include "directions/gauss_4_henon_heiles.hpp"
#include "directions/gauss_4_kepler.hpp"
#include "directions/gauss_4_nonseparable.hpp"
#include "directions/gauss_4_outer_solar_system.hpp"
#include "directions/gauss_8_henon_heiles.hpp"
#include "directions/gauss_8_kepler.hpp"
#include "directions/gauss_8_nonseparable.hpp"
#include "directions/gauss_8_outer_solar_system.hpp"
#include "directions/verlet_henon_heiles.hpp"
#include "directions/verlet_kepler.hpp"
#include "directions/verlet_outer_solar_system.hpp"

namespace {

constexpr std::array<std::size_t, 5> counts{1, 2, 4, 8, 16};

/// The least time of one call of `step`, in nanoseconds of the processor: what else runs on the
/// machine does not count.
template <class Step>
double time_of(int steps, Step step) {
    constexpr int times = 15;
    double best = HUGE_VAL;
    for (int k = 0; k < times; ++k) {
        const std::clock_t begin = std::clock();
        for (int i = 0; i < steps; ++i) { step(); }
        const auto ticks = static_cast<double>(std::clock() - begin);
        best = std::min(best, ticks * (1e9 / CLOCKS_PER_SEC) / steps);
    }
    return best;
}

template <class Stepper>
void measure(const char* method, const char* scene, double h, int steps) {
    using State = typename Stepper::State;
    const double alone = [&] {
        Stepper stepper;
        State x = Stepper::initial();
        return time_of(steps, [&] { static_cast<void>(stepper.step(x, h)); });
    }();
    std::printf("%-15s %-18s %9.1f ns ", method, scene, alone);
    for (const std::size_t count : counts) {
        Stepper stepper;
        State x = Stepper::initial();
        std::vector<State> directions(count, State{});
        for (std::size_t k = 0; k < count; ++k) {
            directions[k].q[k % x.q.size()] = 1;
            directions[k].p[k / 2 % x.q.size()] = 1;
        }
        const double all =
            time_of(steps, [&] { static_cast<void>(stepper.step(x, directions, h)); });
        std::printf(" %7.2f", all / alone);
    }
    std::printf("\n");
}

}  // namespace

int main() {
    using namespace hvi::generated;
    std::printf("%-15s %-18s %12s ", "", "", "a step");
    for (const std::size_t count : counts) { std::printf("  n = %-2zu", count); }
    std::printf("\n");
    measure<Gauss4KeplerDirections>("gauss:4", "kepler", 0.05, 20'000);
    measure<Gauss4NonseparableDirections>("gauss:4", "nonseparable", 0.01, 20'000);
    measure<Gauss4HenonHeilesDirections>("gauss:4", "henon-heiles", 0.1, 20'000);
    measure<Gauss4OuterSolarSystemDirections>("gauss:4", "outer-solar-system", 100, 2000);
    measure<Gauss8KeplerDirections>("gauss:8", "kepler", 0.1, 10'000);
    measure<Gauss8NonseparableDirections>("gauss:8", "nonseparable", 0.02, 10'000);
    measure<Gauss8HenonHeilesDirections>("gauss:8", "henon-heiles", 0.2, 10'000);
    measure<Gauss8OuterSolarSystemDirections>("gauss:8", "outer-solar-system", 200, 1000);
    measure<VerletKeplerDirections>("stormer-verlet", "kepler", 0.01, 200'000);
    measure<VerletHenonHeilesDirections>("stormer-verlet", "henon-heiles", 0.01, 200'000);
    measure<VerletOuterSolarSystemDirections>("stormer-verlet", "outer-solar-system", 10, 20'000);
}
