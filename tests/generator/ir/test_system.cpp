// The record of a system: what contradicts itself is found, and its text says all.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <functional>
#include <utility>

#include <catch2/catch.hpp>

#include "generator/lower/system.hpp"
#include "tests/generator/ir/is_found.hpp"

using namespace hvi::gen;

namespace {

System scene(const char* text) {
    return system_of(unrolled(scene_from_toml(Source{"swing.toml", text})));
}

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
    other.initial[1] = other.initial[0];
    CHECK_FALSE(scene(swing) == other);
}

TEST_CASE("a system that contradicts itself is found") {
    const System right = scene(swing);
    const auto is_wrong = [&](const std::function<void(System&)>& mistake) {
        return is_found<System>(right, mistake);
    };
    CHECK(is_wrong([](System& system) { system.sums.clear(); }));
    CHECK(is_wrong([](System& system) { system.sums[0].by_q[0].access = 1; }));
    CHECK(is_wrong([](System& system) { system.accesses.pop_back(); }));
    CHECK(is_wrong([](System& system) { std::get<Hessian>(system.second).conjugates.clear(); }));
    CHECK(is_wrong([](System& system) { system.initial.pop_back(); }));
    CHECK(is_wrong([](System& system) { system.conjugates.pop_back(); }));
    CHECK(is_wrong([](System& system) { system.structure.is_separable = false; }));
    CHECK(is_wrong([](System& system) { system.structure.has_linear_map = true; }));
    CHECK(is_wrong([](System& system) { system.invariants[0].sums[0].value.node = 1000; }));
}

namespace {

System chain() {
    constexpr const char* text = R"toml(
hamiltonian = "sum(i=1..N, p[i]^2/2) + sum(i=1..N-1, k[1]*(q[i+1] - q[i])^4)"
coordinates = ["q[1..N]"]
momenta = ["p[1..N]"]
[parameters]
N = 100
k = ["1/4", 2]
[initial]
"q[i]" = "i"
"p[i]" = 0
)toml";
    return system_of(scene_from_toml(Source{"chain.toml", text}));
}

}  // namespace

TEST_CASE("the text of a system with loops says what each sum is") {
    const std::string text = dump(chain());
    for (const char* line :
         {"size N: 100\n", "coordinates: q[1..N]\n", "momenta: p[1..N]\n", "table: k[1..2]\n",
          "found: H = T(p) + U(q)\n", "H over i = 1..N: 1/2 #", "H over i = 1..N - 1: #",
          "  by q[i + 1]: ", "  by q[i]: ", "  by p[i]: #",
          "d2H/dq[i + 1] dq[i] over i = 1..N - 1: ", "force on a site, q: 4 #",
          "velocity of a site, p: #", "initial q[1..N]: i: #"}) {
        CAPTURE(text, line);
        CHECK_THAT(text, Catch::Matchers::Contains(line));
    }
    CHECK(chain() == chain());
    System other = chain();
    other.sizes[0].value = 101;
    CHECK_FALSE(chain() == other);
}

TEST_CASE("a system with loops that contradicts itself is found") {
    const System right = chain();
    const auto is_wrong = [&](const std::function<void(System&)>& mistake) {
        return is_found<System>(right, mistake);
    };
    CHECK(is_wrong([](System& system) { system.accesses[0].indices.clear(); }));
    CHECK(is_wrong([](System& system) { system.accesses[0].node = 0; }));
    CHECK(is_wrong([](System& system) { system.conjugates[0].ranges.clear(); }));
    CHECK(is_wrong([](System& system) { system.sums[1].accesses.clear(); }));
    CHECK(is_wrong([](System& system) { system.initial.pop_back(); }));
    CHECK(is_wrong([](System& system) { std::swap(system.sums[0].by_q, system.sums[1].by_q); }));
}
