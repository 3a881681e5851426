// Conservation by steps in natural charts: momentum maps to round-off, and rotations (Theorem 5.3,
// Lemmas 5.4 and 5.5).
// SPDX-License-Identifier: GPL-2.0-or-later
#include <array>
#include <cmath>
#include <cstddef>

#include <groups/bodies_2.hpp>
#include <groups/free_2.hpp>
#include <groups/free_4.hpp>
#include <groups/lagrange_4.hpp>
#include <groups/rotors_2.hpp>
#include <groups/spacecraft_2.hpp>
#include <groups/top_2.hpp>
#include <groups/top_4.hpp>
#include <groups/top_chebyshev.hpp>
#include <groups/top_lobatto.hpp>
#include <groups/top_midpoint.hpp>
#include <groups/top_newton.hpp>
#include <groups/top_trig.hpp>
#include <groups/top_verlet.hpp>
#include <groups/top_yoshida.hpp>

#include "tests/runtime/groups/groups.hpp"

using namespace hvi::generated;

namespace {

/// The largest departures of values(stepper, x), and of the energy, over so many steps.
template <std::size_t n>
struct Seen {
    std::array<double, n> values{};
    double energy = 0, defect = 0;
};

template <class Stepper, class Values>
auto seen(double h, int steps, Values values) {
    Stepper stepper;
    auto x = Stepper::initial();
    const auto start = values(stepper, x);
    const double energy = stepper.energy(x);
    Seen<std::tuple_size_v<decltype(values(stepper, x))>> result;
    for (int i = 0; i < steps; ++i) {
        REQUIRE(stepper.step(x, h).ok());
        const auto now = values(stepper, x);
        for (std::size_t k = 0; k < now.size(); ++k) {
            result.values[k] = std::fmax(result.values[k], std::abs(now[k] - start[k]));
        }
        result.energy = std::fmax(result.energy, std::abs(stepper.energy(x) - energy));
        if constexpr (std::is_same_v<decltype(x.R), std::array<double, 9>>) {
            result.defect = std::fmax(result.defect, groups::defect(x.R));
        }
    }
    return result;
}

template <class Stepper>
double vertical_of_top() {
    const auto result = seen<Stepper>(
        0.1, 2000, [](const auto& stepper, const auto& x) { return std::array{stepper.J_z(x)}; });
    CHECK(result.defect < 5e-15);
    CHECK(result.energy > 1e-9);  // nothing is kept that need not be
    return result.values[0];
}

constexpr auto all_of_J = [](const auto& stepper, const auto& x) {
    return std::array{stepper.J_1(x), stepper.J_2(x), stepper.J_3(x)};
};

}  // namespace

TEST_CASE("a free body: all of its angular momentum in space, which rounding does not move") {
    for (const auto& result :
         {seen<FreeGauss2>(0.25, 20000, all_of_J), seen<FreeGauss4>(0.5, 20000, all_of_J)}) {
        for (const double departure : result.values) { CHECK(departure < 1e-15); }
        CHECK(result.defect < 5e-15);
    }
}

TEST_CASE("a heavy top: the vertical part, by all methods and solvers") {
    CHECK(vertical_of_top<TopMidpoint>() < 3e-15);
    CHECK(vertical_of_top<TopGauss2>() < 3e-15);
    CHECK(vertical_of_top<TopChebyshev3>() < 3e-15);
    CHECK(vertical_of_top<TopLobatto3>() < 3e-15);
    CHECK(vertical_of_top<TopTrig3>() < 3e-15);
    CHECK(vertical_of_top<TopVerlet>() < 3e-15);
    CHECK(vertical_of_top<TopYoshida>() < 3e-15);
    CHECK(vertical_of_top<TopNewton>() < 3e-15);
}

TEST_CASE("a Lagrange top: the vertical part and the spin about its own axis") {
    const auto result = seen<LagrangeGauss4>(0.1, 5000, [](const auto& stepper, const auto& x) {
        return std::array{stepper.J_z(x), stepper.spin(x)};
    });
    CHECK(result.values[0] < 5e-15);
    CHECK(result.values[1] < 5e-14);
}

TEST_CASE("a spacecraft, two bodies and a row of rotors: orbital and own angular momentum") {
    for (const double departure : seen<Spacecraft2>(0.1, 2000, all_of_J).values) {
        CHECK(departure < 5e-15);
    }
    for (const double departure : seen<TwoBodies2>(0.1, 1000, all_of_J).values) {
        CHECK(departure < 5e-15);
    }
    for (const double departure : seen<Rotors2>(0.1, 1000, all_of_J).values) {
        CHECK(departure < 2e-14);
    }
}

TEST_CASE("the energy does not drift") {
    const auto energy = [](int steps) { return seen<FreeGauss2>(0.25, steps, all_of_J).energy; };
    CHECK(energy(40000) < 1.02 * energy(4000));
    // A method of order 8, in steps whose only error is rounding, which grows as their square root
    // at most.
    const auto rounding = seen<TopGauss4>(0.02, 100000, [](const auto& stepper, const auto& x) {
        return std::array{stepper.J_z(x)};
    });
    CHECK(rounding.energy < 1e-14);
    CHECK(rounding.values[0] < 5e-15);
    CHECK(rounding.defect < 5e-15);
}
