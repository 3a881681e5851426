// The record of a system: what contradicts itself is found, and its text says all.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <memory>

#include <catch2/catch.hpp>

#include "generator/lower/system.hpp"
#include "tests/ir/is_found.hpp"

using namespace hvi::gen;

namespace {

System scene(const char* text) { return system_of(scene_from_toml(Source{"swing.toml", text})); }

constexpr const char* swing = R"toml(
hamiltonian = "p^2/2 - w^2*cos(q)"
coordinates = ["q"]
momenta = ["p"]
[parameters]
w = "3/2"
[initial]
q = 1
p = 0
[invariants]
twice = "2*p"
)toml";

}  // namespace

TEST_CASE("the text of a system says what each node computes") {
    // dH/dq = w^2 sin(q), d2H/dq2 = w^2 cos(q); T is p^2/2.
    const std::string text = dump(scene(swing));
    for (const char* line :
         {"scene: swing\n", "coordinates: q\n", "parameter w: 3/2\n", "found: H = T(p) + U(q)\n",
          "found: T is quadratic\n", ": sin #", ": cos #", "dH/dp: #", "d2H/dp dp: #0\n",
          "invariant twice: 2 #", "initial q: #0\n", "initial p: 0\n"}) {
        CAPTURE(text);
        CHECK_THAT(text, Catch::Matchers::Contains(line));
    }
    CHECK_THAT(text, !Catch::Matchers::Contains("d2H/dq dp"));
    CHECK(scene(swing) == scene(swing));
    System other = scene(swing);
    other.initial[1].value = other.initial[0].value;
    CHECK_FALSE(scene(swing) == other);
}

TEST_CASE("a system that contradicts itself is found") {
    const System right = scene(swing);
    CHECK(is_found<System>(right, [](System& system) { system.by_q.clear(); }));
    CHECK(is_found<System>(right, [](System& system) { system.q.clear(); }));
    CHECK(is_found<System>(right, [](System& system) { system.hessian.conjugates.clear(); }));
    CHECK(is_found<System>(right, [](System& system) { system.initial.pop_back(); }));
    CHECK(is_found<System>(right, [](System& system) { system.structure.is_separable = false; }));
    CHECK(is_found<System>(right, [](System& system) { system.structure.has_linear_map = true; }));
    CHECK(is_found<System>(right, [](System& system) { system.invariants[0].value.node = 1000; }));
}
