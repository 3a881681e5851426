// How many iterations stages in lanes take, whoever solves for them, and that the energy stays.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include <catch2/catch.hpp>
#include <lanes/double_pendulum_12.hpp>
#include <lanes/fpu_4_lanes.hpp>
#include <lanes/fpu_lanes.hpp>
#include <lanes/fpu_plain.hpp>
#include <lanes/magnet.hpp>
#include <lanes/masses.hpp>
#include <lanes/vortices_lanes.hpp>

#include "iterations.hpp"

using namespace hvi::generated;

namespace {

/// Long runs are made in part where lanes are computed one by one, which takes ten times as long
/// under sanitizers.
#ifdef HVI_NO_REGISTERS
constexpr int shorter = 5;
#else
constexpr int shorter = 1;
#endif

/// From where the scene begins.
template <class Stepper>
double iterations_of_scene(double h, int steps) {
    return iterations(Stepper{}, Stepper::initial(), h, steps);
}

/// Iterations for a unit of time do not rise as steps grow by `factor` at a time.
template <class Stepper>
void check_no_cliff(double from, double to, double factor) {
    double least = std::numeric_limits<double>::infinity();
    for (double h = from; h < to; h *= factor) {
        const double work = iterations_of_scene<Stepper>(h, 300) / h;
        INFO("h = " << h);
        CHECK(work < 2 * least);
        least = std::min(least, work);
    }
}

/// The energy after so many steps, beside that at the beginning.
template <class Stepper>
double change_of_energy(double h, int steps) {
    Stepper stepper;
    auto x = Stepper::initial();
    const double energy = stepper.energy(x);
    for (int i = 0; i < steps / shorter; ++i) { REQUIRE(stepper.step(x, h).ok()); }
    return std::abs(stepper.energy(x) / energy - 1);
}

}  // namespace

// The bounds are from an independent program, which shares nothing with these headers, for the form
// of positions: 23.5 and, where fixed points diverge, none; with the linear part solved exactly 6.2
// and 8.9. Our steppers take one more iteration to end, and trials of other solvers count.
TEST_CASE("where the linear part is solved exactly, sweeps do not depend on h omega") {
    CHECK(iterations_of_scene<FpuPlain>(0.1, 200) > 25);
    CHECK(iterations_of_scene<FpuLanes>(0.1, 1000) < 11);
    CHECK(iterations_of_scene<FpuLanes>(0.15, 1000) < 14);
    CHECK(iterations_of_scene<FpuLanes>(0.5, 500) < 22);  // h omega = 25
}

// Sweeps from extrapolated slopes, given up for Newton's method, rose by factors here.
TEST_CASE("a larger step does not suddenly cost more") {
    check_no_cliff<DoublePendulum12>(0.05, 0.75, 1.1);
    check_no_cliff<FpuLanes>(0.02, 1, 1.1);
    check_no_cliff<Masses>(0.1, 0.6, 1.1);  // below, many sweeps cost as much as few of these
    check_no_cliff<Magnet>(0.02, 2, 1.1);
    check_no_cliff<VorticesLanes>(0.5, 9, 1.2);
}

TEST_CASE("the linear part of many steps leaves the energy to rounding alone") {
    CHECK(change_of_energy<FpuLanes>(0.03, 30'000) < 2e-13);
    CHECK(change_of_energy<Fpu4Lanes>(0.004, 30'000) < 1e-13);
    CHECK(change_of_energy<Masses>(0.03, 30'000) < 2e-13);
    CHECK(change_of_energy<Magnet>(0.05, 30'000) < 2e-13);
}

TEST_CASE("lanes and single stages take the same step, where one solves the linear part alone") {
    FpuLanes lanes;
    FpuPlain plain;
    auto x = FpuLanes::initial();
    auto y = FpuPlain::initial();
    for (int i = 0; i < 5; ++i) {
        REQUIRE(lanes.step(x, 0.1).ok());
        REQUIRE(plain.step(y, 0.1).ok());
    }
    for (std::size_t k = 0; k < 6; ++k) {
        CHECK(x.q[k] == Approx(y.q[k]).margin(1e-13));
        CHECK(x.p[k] == Approx(y.p[k]).margin(1e-12));
    }
}
