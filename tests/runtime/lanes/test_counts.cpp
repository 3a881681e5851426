// How many iterations and evaluations the steps of each scene take: counts do not depend on the
// machine.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <array>
#include <cmath>
#include <string>

#include <catch2/catch.hpp>
#include <lanes/double_pendulum_8.hpp>
#include <lanes/fpu_lanes.hpp>
#include <lanes/henon_heiles_8.hpp>
#include <lanes/kepler_8.hpp>
#include <lanes/magnet.hpp>
#include <lanes/masses.hpp>
#include <lanes/nonseparable_8.hpp>
#include <lanes/pendulum_8.hpp>
#include <lanes/solar_system_8.hpp>
#include <lanes/vortices_lanes.hpp>

#include "iterations.hpp"

using namespace hvi::generated;

namespace {

constexpr int stages = 8;

/// Sweeps of a step size to where changes are below two roundings, by a program in which nothing is
/// shared with these headers: starting values of the last step's polynomial, each slope used at
/// once, and the momenta eliminated or, where H couples them with q, both gradients at once.
struct Sweeps {
    double h, count;
};

/// Counts sweeps. One or two more than expected see that nothing falls any more, and there are
/// trials of other ways.
template <class Stepper>
void check_sweeps(const std::array<Sweeps, 3>& expected) {
    for (const auto& [h, count] : expected) {
        INFO("h = " << h);
        const double found = iterations(Stepper{}, Stepper::initial(), h, 300);
        CHECK(found < 1.15 * count + 2);
        CHECK(found > count - 1);
    }
}

/// Each iteration evaluates dH/dq once at each stage, and the first step once more at its start.
template <class Stepper>
void check_evaluations(double h) {
    Stepper stepper;
    auto x = Stepper::initial();
    long iterations = 0;
    constexpr int steps = 50;
    for (int i = 0; i < steps; ++i) {
        const auto status = stepper.step(x, h);
        REQUIRE(status.ok());
        iterations += status.iterations;
    }
    CHECK(stepper.evaluations() >= stages * (iterations - steps));
    CHECK(stepper.evaluations() <= stages * (iterations + steps));
}

}  // namespace

TEST_CASE("sweeps of a step: positions alone") {
    check_sweeps<Pendulum8>({{{0.1, 2.2}, {0.3, 3.7}, {0.5, 4.8}}});
    check_sweeps<HenonHeiles8>({{{0.1, 2.1}, {0.3, 4.0}, {0.5, 5.4}}});
    check_sweeps<Kepler8>({{{0.05, 2.1}, {0.15, 3.5}, {0.4, 5.7}}});
    check_sweeps<SolarSystem8>({{{100, 2.8}, {300, 4.8}, {900, 9.2}}});
}

TEST_CASE("sweeps of a step: pairs") {
    check_sweeps<Nonseparable8>({{{0.1, 7.8}, {0.2, 11}, {0.3, 13.5}}});
    check_sweeps<VorticesLanes>({{{0.3, 4.5}, {1, 5.8}, {3, 9.8}}});
}

TEST_CASE("evaluations are those of the iterations") {
    check_evaluations<Pendulum8>(0.3);
    check_evaluations<HenonHeiles8>(0.3);
    check_evaluations<Kepler8>(0.15);
    check_evaluations<SolarSystem8>(300);
    check_evaluations<Nonseparable8>(0.2);
    check_evaluations<DoublePendulum8>(0.2);
}

// ---- what is stiff ----

namespace {

/// A factor of sqrt(10) at a time; the stiff spring that moves has the energy of the soft ones, or
/// their amplitude. `start(d)` is where the chain begins, that spring being longer by d.
template <class Chain, class Start>
void check_stiff(Start start) {
    constexpr double h = 0.02;
    for (double z = 1e-3; z < 1.1e4; z *= std::sqrt(10.0)) {
        const double omega = z / h;
        typename Chain::Parameters parameters;
        parameters.omega = omega;
        const double found = iterations(Chain(parameters), start(std::min(1.0, 1 / omega)), h, 500);
        INFO("h omega = " << z);
        CHECK(found < 8.5);
    }
}

}  // namespace

TEST_CASE("h omega from 1e-3 to 1e4: iterations of chains with stiff springs by themselves") {
    check_stiff<FpuLanes>([](double d) {
        return FpuLanes::State{{1, 0, 0, d, 0, 0}, {1, 0, 0, 1, 0, 0}};
    });
}

TEST_CASE("h omega from 1e-3 to 1e4: iterations of chains whose stiff springs couple") {
    check_stiff<Masses>([](double d) {
        const double r = std::sqrt(0.5);
        return Masses::State{{r * (1 - d), r * (1 + d), 0, 0, 0, 0}, {0, 2 * r, 0, 0, 0, 0}};
    });
}

TEST_CASE("constant terms that couple positions with momenta are solved for as well") {
    // A charge turns with w = 10; an iteration with both gradients at once contracts with h w/4.
    CHECK(iterations(Magnet{}, Magnet::initial(), 0.5, 300) < 20);
    CHECK(iterations(Magnet{}, Magnet::initial(), 1.0, 300) < 22);
    CHECK(iterations(Magnet{}, Magnet::initial(), 2.0, 300) < 22);
}
