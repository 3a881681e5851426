// The record of what is known of H where a step is planned.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "generator/ir/properties.hpp"
#include "tests/generator/ir/is_found.hpp"

using namespace hvi::gen;

namespace {

const SystemProperties springs{.is_separable = true,
                               .kinetic_is_quadratic = true,
                               .degrees_of_freedom = 3,
                               .linear = StiffComponents{{0, 2}},
                               .container = Container::arrays};

bool is_wrong(const std::function<void(SystemProperties&)>& mistake) {
    return is_found<SystemProperties>(springs, mistake);
}

}  // namespace

TEST_CASE("the text of properties says what is found, and equality looks at all") {
    const std::string text = dump(springs);
    for (const char* line : {"degrees of freedom: 3\n", "vectors: arrays\n", "found: T(p) + U(q)\n",
                             "found: T is quadratic\n", "linear part: components 0 2\n"}) {
        CHECK_THAT(text, Catch::Matchers::Contains(line));
    }
    CHECK_THAT(text, !Catch::Matchers::Contains("lattice"));
    SystemProperties other = springs;
    CHECK(other == springs);
    other.linear = CoupledConstants{};
    CHECK_FALSE(other == springs);
}

TEST_CASE("properties that contradict each other are found") {
    CHECK(is_wrong([](SystemProperties& system) { system.is_separable = false; }));
    CHECK(is_wrong([](SystemProperties& system) {
        system.kinetic_is_quadratic = false;
        system.has_diagonal_mass = true;
    }));
    CHECK(is_wrong(
        [](SystemProperties& system) { system.has_linear_map = system.depends_on_time = true; }));
    CHECK(is_wrong([](SystemProperties& system) { system.is_lattice = true; }));
    CHECK(is_wrong([](SystemProperties& system) { system.rotations = 2; }));
    CHECK(is_wrong([](SystemProperties& system) { system.degrees_of_freedom = 2; }));
}
