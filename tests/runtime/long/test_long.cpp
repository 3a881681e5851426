// Many steps: symmetry, drift.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>

#include <catch2/catch.hpp>
#include <hvi/generated/gauss_1.hpp>
#include <hvi/generated/gauss_2.hpp>
#include <hvi/generated/gauss_2_separable.hpp>
#include <hvi/generated/gauss_3.hpp>
#include <hvi/generated/gauss_4.hpp>
#include <hvi/generated/lobatto_2.hpp>
#include <hvi/generated/lobatto_3.hpp>
#include <hvi/generated/lobatto_3_separable.hpp>
#include <hvi/generated/lobatto_4.hpp>
#include <hvi/generated/midpoint.hpp>
#include <hvi/generated/stormer_verlet_separable.hpp>
#include <hvi/generated/symplectic_euler_separable.hpp>
#include <hvi/generated/trig3.hpp>
#include <hvi/newton.hpp>

#include "tests/runtime/run/systems.hpp"

using namespace hvi::generated;

namespace {

using State = hvi::State<systems::Two>;
using Kepler = systems::AsGeneral<systems::Kepler>;
const State orbit{{1.0, 0.2}, {0.1, 0.9}};

/// The largest component of the distance from the start after a step there and back.
template <class Stepper>
double there_and_back(Stepper stepper, double h) {
    State x = orbit;
    REQUIRE(stepper.step(x, h).ok());
    REQUIRE(stepper.step(x, -h).ok());
    double distance = 0.0;
    for (std::size_t k = 0; k < 2; ++k) {
        distance = std::fmax(distance, std::abs(x.q[k] - orbit.q[k]));
        distance = std::fmax(distance, std::abs(x.p[k] - orbit.p[k]));
    }
    return distance;
}

}  // namespace

TEST_CASE("a step back returns, for self-adjoint methods only") {
    CHECK(there_and_back(Midpoint<Kepler>{}, 0.3) < 1e-15);
    CHECK(there_and_back(Gauss1<Kepler>{}, 0.3) < 1e-15);
    CHECK(there_and_back(Gauss2<Kepler>{}, 0.3) < 1e-15);
    CHECK(there_and_back(Gauss3<Kepler>{}, 0.3) < 1e-15);
    CHECK(there_and_back(Gauss4<Kepler>{}, 0.3) < 1e-15);
    CHECK(there_and_back(Lobatto2<Kepler>{}, 0.3) < 1e-15);
    CHECK(there_and_back(Lobatto3<Kepler>{}, 0.3) < 1e-15);
    CHECK(there_and_back(Lobatto4<Kepler>{}, 0.3) < 1e-15);
    CHECK(there_and_back(Trig3<Kepler>{}, 0.3) < 1e-15);
    CHECK(there_and_back(Gauss2Separable<systems::Kepler>{}, 0.3) < 1e-15);
    CHECK(there_and_back(Lobatto3Separable<systems::Kepler>{}, 0.3) < 1e-15);
    CHECK(there_and_back(StormerVerletSeparable<systems::Kepler>{}, 0.3) < 1e-15);
    CHECK(there_and_back(SymplecticEulerSeparable<systems::Kepler>{}, 0.3) > 1e-3);
}

TEST_CASE("the energy of Gauss on the oscillator walks at random, it does not drift") {
    // NOTE: with coefficients rounded one by one the energy would drift, to 1.3e-13 here.
    Gauss2<systems::Oscillator> stepper;
    hvi::State<systems::One> x{{2.0}, {1.0}};
    double worst = 0.0;
    for (int i = 0; i < 1'000'000; ++i) {
        if (!stepper.step(x, 0.1).ok()) { FAIL("no convergence"); }
        const double error = (x.p[0] * x.p[0] + x.q[0] * x.q[0]) / 5 - 1.0;
        worst = std::fmax(worst, std::abs(error));
    }
    CHECK(worst < 5e-14);
}

TEST_CASE("the energy of Kepler's problem does not drift over many orbits") {
    Gauss4<Kepler> stepper;
    State x = orbit;
    const double energy = systems::Kepler::energy(x);
    double worst = 0.0;
    for (int i = 0; i < 200'000; ++i) {
        if (!stepper.step(x, 0.02).ok()) { FAIL("no convergence"); }
        worst = std::fmax(worst, std::abs(systems::Kepler::energy(x) / energy - 1.0));
    }
    CHECK(worst < 2e-13);
}

TEST_CASE("nor does it with Newton's method") {
    // Mean errors over the first and the last quarter. Iterations that end at a correction of 4
    // roundings drift apart by 3e-14.
    constexpr int quarter = 100'000;
    Gauss4<Kepler, hvi::Newton> stepper;
    State x = orbit;
    const double energy = systems::Kepler::energy(x);
    const auto mean_error = [&] {
        double sum = 0.0;
        for (int i = 0; i < quarter; ++i) {
            if (!stepper.step(x, 0.05).ok()) { FAIL("no convergence"); }
            sum += systems::Kepler::energy(x) / energy - 1.0;
        }
        return sum / quarter;
    };
    const double first = mean_error();
    static_cast<void>(mean_error());
    static_cast<void>(mean_error());
    CHECK(std::abs(mean_error() - first) < 1.5e-14);
}
