// The energy over hundreds of thousands of steps.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

#include <catch2/catch.hpp>
#include <scene/chain.hpp>
#include <scene/fixed_kepler.hpp>
#include <scene/harmonic_oscillator.hpp>
#include <scene/magnet.hpp>
#include <scene/newton_kepler.hpp>
#include <scene/rotating.hpp>
#include <scene/taylor_kepler.hpp>

using namespace hvi::generated;

namespace {

/// Fails where a step does. NOTE: a REQUIRE for each step takes longer than the steps.
template <class Stepper>
void walk(Stepper& stepper, typename Stepper::State& x, double h, int steps) {
    int done = 0;
    while (done < steps && stepper.step(x, h).ok()) { ++done; }
    REQUIRE(done == steps);
}

/// The relative errors of the energy after so many steps of the stepper, and of products with the
/// rounded entries of its matrix, which is without offset.
struct EnergyErrors {
    double of_stepper, of_matrix;
};

template <class Stepper>
EnergyErrors energy_errors(const typename Stepper::State& start, double h, int steps) {
    constexpr std::size_t n = std::tuple_size_v<typename Stepper::Vector>;
    Stepper stepper;
    typename Stepper::State x = start;
    walk(stepper, x, h, steps);
    std::array<std::array<double, 2 * n>, 2 * n> R{};
    for (std::size_t j = 0; j < 2 * n; ++j) {
        typename Stepper::State unit;
        (j < n ? unit.q : unit.p)[j % n] = 1;
        REQUIRE(stepper.step(unit, h).ok());
        for (std::size_t i = 0; i < 2 * n; ++i) { R[i][j] = (i < n ? unit.q : unit.p)[i % n]; }
    }
    typename Stepper::State y = start;
    for (int k = 0; k < steps; ++k) {
        typename Stepper::State next;
        for (std::size_t i = 0; i < 2 * n; ++i) {
            double& sum = (i < n ? next.q : next.p)[i % n];
            for (std::size_t j = 0; j < 2 * n; ++j) { sum += R[i][j] * (j < n ? y.q : y.p)[j % n]; }
        }
        y = next;
    }
    const double energy = stepper.energy(start);
    return {std::abs(stepper.energy(x) / energy - 1), std::abs(stepper.energy(y) / energy - 1)};
}

/// The mean energy error over the last tenth of a run.
template <class Stepper>
double late_energy_error(double h, int steps) {
    Stepper stepper;
    auto x = Stepper::initial();
    const double energy = stepper.energy(x);
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        if (!stepper.step(x, h).ok()) { return std::numeric_limits<double>::infinity(); }
        if (i >= steps - steps / 10) { sum += stepper.energy(x) / energy - 1; }
    }
    return sum / (steps / 10);
}

}  // namespace

TEST_CASE("the energy of an oscillator over a million steps") {
    HarmonicOscillator stepper;
    HarmonicOscillator::State x = HarmonicOscillator::initial();
    walk(stepper, x, 0.1, 1'000'000);
    CHECK(std::abs(2 * stepper.energy(x) - 1.0) < 5e-13);
}

TEST_CASE("the energy of coupled masses over a million steps wanders, and does not drift") {
    const auto [change, drift] =
        energy_errors<Chain>({{0.5, -0.25, 1.0}, {0.125, 0.75, -0.5}}, 0.1, 1'000'000);
    INFO("shears: " << change << ", matrix: " << drift);
    CHECK(change < 5e-13);
    CHECK(drift > 1e-11);
}

TEST_CASE("in a rotating frame and in a magnetic field the energy does not drift either") {
    // NOTE: where small terms are added to the increment first, h = 1/2 drifts by 2e-13.
    for (const double h : {0.1, 0.5, -0.25}) {
        const auto rotating = energy_errors<Rotating>({{0.5, -0.25}, {0.125, 0.75}}, h, 1'000'000);
        const auto magnet = energy_errors<Magnet>({{0.5, -0.25}, {0.125, 0.75}}, h, 1'000'000);
        INFO("h = " << h << ": " << rotating.of_stepper << " and " << rotating.of_matrix << ", "
                    << magnet.of_stepper << " and " << magnet.of_matrix);
        CHECK(rotating.of_stepper < 1e-13);
        CHECK(magnet.of_stepper < 1e-13);
        CHECK(rotating.of_matrix > 1e-11);
        CHECK(magnet.of_matrix > 1e-11);
    }
}

TEST_CASE("the energy drifts with no solver of the equations of a step") {
    const double h = 0.05;
    const int steps = 100'000;
    const double expected = late_energy_error<FixedKepler>(h, steps);
    CHECK(std::abs(late_energy_error<NewtonKepler>(h, steps) - expected) < 2e-13);
    CHECK(std::abs(late_energy_error<TaylorKepler>(h, steps) - expected) < 2e-13);
}
