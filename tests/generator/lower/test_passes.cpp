// Passes that make another function of a system, before anything is found in it.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <string>
#include <utility>

#include <catch2/catch.hpp>

#include "generator/lower/homogeneous.hpp"
#include "generator/lower/slopes.hpp"
#include "generator/lower/system.hpp"
#include "generator/lower/tangent.hpp"
#include "tests/generator/read/refusal.hpp"

using namespace hvi::gen;

namespace {

/// A system of H^2 where it is written out, else of 3 H.
System of_other_function(System system) {
    for (SystemSum& sum : system.sums) {
        sum.value = system.is_written_out() ? system.graph.product(sum.value, sum.value)
                                            : system.graph.times({3, 1}, sum.value);
    }
    return differentiated(std::move(system));
}

constexpr const char* one_spring = R"toml(
hamiltonian = "p^2/2 + q^2/2"
coordinates = ["q"]
momenta = ["p"]
[initial]
q = 1
p = 0
)toml";

constexpr const char* row_of_springs = R"toml(
hamiltonian = "sum(i=1..N, p[i]^2/2) + sum(i=1..N-1, (q[i+1] - q[i])^4)"
coordinates = ["q[1..N]"]
momenta = ["p[1..N]"]
[parameters]
N = 100
[initial]
"q[i]" = "i"
"p[i]" = 0
)toml";

}  // namespace

TEST_CASE("what is found in a system is that of what passes have made of it") {
    const WrittenOutScene scene = unrolled(scene_from_toml(Source{"spring.toml", one_spring}));
    CHECK(system_of(scene).structure.is_separable);
    const System square = system_of(scene, {of_other_function});
    CHECK_FALSE(square.structure.is_separable);
    CHECK(energy_of(square) == function_of(square));
    CHECK(function_of(square) != function_of(system_of(scene)));
}

TEST_CASE("and so where sums stay loops") {
    const Scene scene = scene_from_toml(Source{"springs.toml", row_of_springs});
    const System once = system_of(scene), thrice = system_of(scene, {of_other_function});
    CHECK(thrice.structure.has_diagonal_mass);
    REQUIRE(thrice.sites.has_value());
    REQUIRE(once.sums.size() == thrice.sums.size());
    const SmallFraction three{3, 1};
    for (std::size_t s = 0; s < once.sums.size(); ++s) {
        CHECK(thrice.energy[s].value == thrice.sums[s].value);
        CHECK(thrice.sums[s].value.factor == three * once.sums[s].value.factor);
    }
    CHECK(thrice.sites->forces[0].factor == three * once.sites->forces[0].factor);
}

TEST_CASE("directions of a lattice are a lattice with them") {
    const Scene scene = scene_from_toml(Source{"springs.toml", row_of_springs});
    const System K = system_of(scene, {with_tangent});
    CHECK(K.degrees_of_freedom() == 200);
    REQUIRE(K.coordinates.size() == 2);
    CHECK(K.coordinates[1].name == "d_q");
    CHECK(K.conjugates[0].name == "d_p");
    CHECK(K.conjugates[1].name == "p");
    REQUIRE(K.sites.has_value());
    CHECK(K.sites->reach == std::vector<long>{1});
    CHECK(K.structure.kinetic_is_quadratic);
    CHECK_FALSE(K.structure.has_diagonal_mass);
    REQUIRE(K.initial.size() == 4);
    for (const std::size_t direction : {std::size_t{1}, std::size_t{2}}) {
        const auto& zero = std::get<SystemStart::Rule>(K.initial[direction].values);
        CHECK(zero.indices.size() == 1);
        CHECK(zero.value.is_zero());
    }
    // The energy is that of the springs.
    const System H = system_of(scene);
    REQUIRE(K.energy.size() == H.energy.size());
    for (std::size_t s = 0; s < H.energy.size(); ++s) CHECK(K.energy[s].loops == H.energy[s].loops);
}

TEST_CASE("what is homogeneous is separable where H is, and has a quadratic T where H has one") {
    const auto extended = [](const std::string& H) {
        const std::string text = "hamiltonian = \"" + H +
                                 "\"\ncoordinates = [\"q\"]\nmomenta = [\"p\"]\n"
                                 "parameters = {m = 2}\ninitial = {q = 1, p = 0}\n";
        return system_of(unrolled(scene_from_toml(Source{"scene.toml", text})),
                         {with_homogeneous_extension});
    };
    for (const std::string H : {"p^2/2 + q^4", "p^2/(2*m) - cos(q)", "m*(3*p^2 + sqrt(1 + q^2))"}) {
        const System system = extended(H);
        CAPTURE(H);
        CHECK(system.structure.is_separable);
        CHECK(system.structure.kinetic_is_quadratic);
        CHECK(system.degrees_of_freedom() == 2);
        CHECK(start_of(system).size() == 4);
    }
    const System relativistic = extended("m*(sqrt(1 + p^2) + q^2)");
    CHECK(relativistic.structure.is_separable);
    CHECK_FALSE(relativistic.structure.kinetic_is_quadratic);
    CHECK(relativistic.degrees_of_freedom() == 3);
    CHECK_FALSE(extended("p^2/2 + q^2*p").structure.is_separable);
}
