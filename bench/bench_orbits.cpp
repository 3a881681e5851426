// Planets as Kepler orbits and what disturbs them: generated steps against those by hand, and
// against drifts and kicks.
// SPDX-License-Identifier: MIT
//
// Before anything is timed, both splittings go the same way.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>

#include <hvi/state.hpp>

#include "orbits/heliocentric.hpp"
#include "orbits/jacobi.hpp"
#include "orbits/jacobi_8_4.hpp"
#include "orbits_by_hand.hpp"
#include "report.hpp"
#include "scene/verlet_solar_system.hpp"

namespace {

using namespace hvi::generated;
using bench::OrbitsByHand;

constexpr double h = 50;
constexpr int steps = 1000;

OrbitsByHand by_hand() {
    const JacobiOrbits::Parameters parameters;
    const auto x = JacobiOrbits::initial();
    std::array<double, OrbitsByHand::bodies> masses{};
    OrbitsByHand::Vectors positions{}, velocities{};
    for (std::size_t j = 0; j < masses.size(); ++j) {
        masses[j] = parameters.m[j];
        for (std::size_t a = 0; a < 3; ++a) {
            positions[j][a] = x.q[6 * a + j];
            velocities[j][a] = x.p[6 * a + j] / masses[j];
        }
    }
    return {parameters.G, masses, positions, velocities};
}

/// Returns how far apart both are after many steps.
double apart() {
    JacobiOrbits stepper;
    auto x = JacobiOrbits::initial();
    OrbitsByHand other = by_hand();
    for (int k = 0; k < steps; ++k) {
        if (!stepper.step(x, h).ok()) { return INFINITY; }
        other.step(h);
    }
    double largest = 0;
    for (std::size_t j = 1; j < OrbitsByHand::bodies; ++j) {
        const OrbitsByHand::Vector d = other.from_first(j);
        for (std::size_t a = 0; a < 3; ++a) {
            const double ours = x.q[6 * a + j] - x.q[6 * a];
            largest = std::max(largest, std::abs(ours - d[a]));
        }
    }
    return largest;
}

template <class Stepper>
void generated(benchmark::State& state) {
    Stepper stepper;
    auto x = Stepper::initial();
    for (auto _ : state) {
        for (int k = 0; k < steps; ++k) { benchmark::DoNotOptimize(stepper.step(x, h)); }
    }
}

void hand(benchmark::State& state) {
    OrbitsByHand stepper = by_hand();
    for (auto _ : state) {
        for (int k = 0; k < steps; ++k) { stepper.step(h); }
        benchmark::DoNotOptimize(stepper);
    }
}

}  // namespace

int main(int argc, char** argv) {
    constexpr double most = 1e-9;
    const double distance = apart();
    if (!(distance < most)) {
        std::printf("the splittings are %g apart after %d steps\n", distance, steps);
        return 1;
    }
    benchmark::RegisterBenchmark("by_hand", hand);
    benchmark::RegisterBenchmark("jacobi", generated<JacobiOrbits>);
    benchmark::RegisterBenchmark("jacobi_8_4", generated<JacobiOrbits84>);
    benchmark::RegisterBenchmark("heliocentric", generated<HeliocentricOrbits>);
    benchmark::RegisterBenchmark("verlet", generated<VerletSolarSystem>);
    return bench::time_all(argc, argv,
                           {{"by_hand", "jacobi", "at least 2"},
                            {"by_hand", "heliocentric", "at least 2"},
                            {"jacobi_8_4", "jacobi", "at most 3.5: 6 orbits to 2"},
                            {"jacobi", "verlet", "as it comes; errors differ by 1000"}});
}
