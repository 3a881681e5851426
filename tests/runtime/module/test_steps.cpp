// Steps of modules: those of the same steppers in C++, bit by bit.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <chain.h>
#include <driven.h>
#include <kepler.h>
#include <masses.h>
#include <pendulums.h>
#include <top.h>

#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <module/chain.hpp>
#include <module/driven.hpp>
#include <module/kepler.hpp>
#include <module/masses.hpp>
#include <module/pendulums.hpp>
#include <module/top.hpp>

#include "tests/runtime/module/bits.hpp"

namespace {

using namespace hvi::generated;

/// Steps one by one, in a row, and in C++.
template <class Stepper, class Handle>
void check_steps(const Functions<Handle>& functions, double h) {
    constexpr int steps = 40;
    Module<Handle> one_by_one(functions), in_a_row(functions);
    const std::vector<double> expected = in_cpp_after<Stepper>(steps, h);
    CHECK(same_bits(one_by_one.after(steps, h), expected));
    std::vector<double> x = in_a_row.initial();
    CHECK(same_bits(x, numbers_and_time<Stepper>(Stepper::initial())));
    REQUIRE(in_a_row.call.integrate(in_a_row.handle, x.data(), 0, h, steps, 0, nullptr, nullptr, 0,
                                    nullptr) == 0);
    CHECK(same_bits(x, expected));
}

TEST_CASE("a module takes the steps of the stepper in C++") {
    check_steps<KeplerInCpp>(FUNCTIONS_OF(kepler), 0.05);
    check_steps<ChainInCpp>(FUNCTIONS_OF(chain), 0.1);
    check_steps<MassesInCpp>(FUNCTIONS_OF(masses), 0.01);
    check_steps<DrivenInCpp>(FUNCTIONS_OF(driven), 0.1);
    check_steps<TopInCpp>(FUNCTIONS_OF(top), 0.25);
    check_steps<PendulumsInCpp>(FUNCTIONS_OF(pendulums), 0.01);
}

template <class Stepper, class Handle>
void check_energy(const Functions<Handle>& functions) {
    const Module<Handle> module(functions);
    double energy = 0;
    REQUIRE(module.call.energy(module.handle, module.initial().data(), &energy) == 0);
    CHECK(energy == Stepper().energy(Stepper::initial()));
}

TEST_CASE("a module computes the energies of the stepper in C++") {
    check_energy<KeplerInCpp>(FUNCTIONS_OF(kepler));
    check_energy<ChainInCpp>(FUNCTIONS_OF(chain));
    check_energy<MassesInCpp>(FUNCTIONS_OF(masses));
    check_energy<DrivenInCpp>(FUNCTIONS_OF(driven));
    check_energy<TopInCpp>(FUNCTIONS_OF(top));
    check_energy<PendulumsInCpp>(FUNCTIONS_OF(pendulums));
}

TEST_CASE("a copy goes on as its original would, and a stepper that is reset as a fresh one") {
    constexpr double h = 0.1;
    Module<kepler_stepper> first(FUNCTIONS_OF(kepler));
    std::vector<double> x = first.after(7, h), y = x, z = x, fresh = x;
    kepler_stepper* copied = nullptr;
    REQUIRE(kepler_copy(first.handle, &copied) == 0);
    REQUIRE(kepler_step(first.handle, x.data(), h) == 0);
    REQUIRE(kepler_step(copied, y.data(), h) == 0);
    CHECK(same_bits(x, y));
    REQUIRE(kepler_destroy(copied) == 0);

    REQUIRE(kepler_reset(first.handle) == 0);
    Module<kepler_stepper> other(FUNCTIONS_OF(kepler));
    REQUIRE(kepler_step(first.handle, z.data(), h) == 0);
    REQUIRE(kepler_step(other.handle, fresh.data(), h) == 0);
    CHECK(same_bits(z, fresh));
    // The last bits show what is forgotten: else this tests nothing.
    CHECK_FALSE(same_bits(x, z));
}

TEST_CASE("a step that cannot be taken leaves every bit, and ends a run with the rows before it") {
    Module<kepler_stepper> planet(FUNCTIONS_OF(kepler));
    std::vector<double> at_sun = {0, 0, 0.5, 0}, before = at_sun;
    const int status = kepler_step(planet.handle, at_sun.data(), 0.1);
    CHECK(std::string(kepler_status_text(status)).find("infinite or not a number") !=
          std::string::npos);
    CHECK(same_bits(at_sun, before));

    // A comet that falls into the sun has rows of the steps before.
    std::vector<double> falling = {1, 0, -0.5, 0}, table(400 * 5, -7.0);
    std::size_t written = 0;
    CHECK(kepler_integrate(planet.handle, falling.data(), 0, 0.02, 400, 1, nullptr, table.data(),
                           400, &written) != 0);
    REQUIRE(written > 0);
    REQUIRE(written < 400);
    CHECK(std::vector<double>(table.begin() + static_cast<std::ptrdiff_t>(5 * written) - 4,
                              table.begin() + static_cast<std::ptrdiff_t>(5 * written)) == falling);
    CHECK(table[5 * written] == -7);
}

TEST_CASE("a module counts steps, iterations and evaluations") {
    std::int64_t steps = 0, iterations = 0, evaluations = 0;
    Module<kepler_stepper> planet(FUNCTIONS_OF(kepler));
    static_cast<void>(planet.after(5, 0.01));
    REQUIRE(kepler_counts(planet.handle, &steps, &iterations, &evaluations) == 0);
    CHECK(steps == 5);
    KeplerInCpp stepper;
    auto x = KeplerInCpp::initial();
    std::int64_t expected = 0;
    for (int k = 0; k < 5; ++k) { expected += stepper.step(x, 0.01).iterations; }
    CHECK(iterations == expected);
    CHECK(evaluations == stepper.evaluations());
    CHECK(kepler_counts(planet.handle, nullptr, nullptr, nullptr) == 0);
}

}  // namespace
