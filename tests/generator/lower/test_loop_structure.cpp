// Structure that is found in systems whose sums stay loops.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <string>

#include <catch2/catch.hpp>

#include "generator/lower/system.hpp"
#include "generator/read/no_loops.hpp"
#include "tests/generator/read/refusal.hpp"

using namespace hvi::gen;

namespace {

/// A chain of 100 places with this H, or L.
System chain(const std::string& function, const std::string& of = "hamiltonian") {
    const std::string conjugates = of == "hamiltonian" ? "momenta" : "velocities";
    const std::string text = of + " = \"" + function + "\"\n" + "coordinates = [\"q[1..N]\"]\n" +
                             conjugates + " = [\"p[1..N]\"]\n" +
                             R"toml(
[parameters]
N = 100
m = [1, 2]
[initial]
"q[i]" = "i"
"p[i]" = 1
)toml";
    return system_of(scene_from_toml(Source{"chain.toml", text}));
}

constexpr const char* row_of_springs_energy = " + sum(i=1..N-1, (q[i+1] - q[i])^2)";

Structure with_kinetic(const std::string& T) { return chain(T + row_of_springs_energy).structure; }

}  // namespace

TEST_CASE("a kinetic energy of sums is quadratic where its derivatives say so") {
    for (const char* T : {"sum(i=1..N, p[i]^2)", "sum(i=1..N, (i + 1)*p[i]^2)",
                          "sum(i=1..N, (p[i]^2 + i*p[i]^2)/2)", "sum(i=1..N, (m[1] + i^2)*p[i]^2)",
                          "sum(i=1..N, (p[i] + i*p[i])^2)", "sum(i=1..N, min(i, 50)*p[i]^2)"}) {
        CAPTURE(T);
        const Structure found = with_kinetic(T);
        CHECK(found.kinetic_is_quadratic);
        CHECK(found.has_diagonal_mass);
        CHECK(found.is_quadratic);
    }
    for (const char* T :
         {"sum(i=1..N-1, (p[i+1] + p[i])^2)", "sum(i=1..N-1, (i + 1)*(p[i+1] + (i + 2)*p[i])^2)"}) {
        CAPTURE(T);
        CHECK(with_kinetic(T).kinetic_is_quadratic);
        CHECK_FALSE(with_kinetic(T).has_diagonal_mass);
    }
}

TEST_CASE("what is no quadratic kinetic energy of sums") {
    for (const char* T : {"sum(i=1..N, (i + 1)*p[i]^4)", "sum(i=1..N, sqrt(1 + p[i]^2))",
                          "sum(i=1..N, p[i]^2 + p[i])", "sum(i=1..N, abs(p[i]))",
                          "sum(i=1..N, p[i]^2 + i*abs(p[i]))", "sum(i=1..N, p[i])^2",
                          "sum(i=1..N, p[i]^2)*sum(i=1..N, p[i]^2)"}) {
        CAPTURE(T);
        CHECK(with_kinetic(T).is_separable);
        CHECK_FALSE(with_kinetic(T).kinetic_is_quadratic);
    }
    CHECK_FALSE(with_kinetic("sum(i=1..N, cos(t)*p[i]^2)").is_separable);
    CHECK_FALSE(chain("sum(i=1..N, q[i]^2*p[i]^2)").structure.is_separable);
}

TEST_CASE("potentials of sums that have kinks are not quadratic") {
    CHECK(chain("sum(i=1..N, p[i]^2 + (i + 1)*q[i]^2)").structure.is_quadratic);
    CHECK_FALSE(chain("sum(i=1..N, p[i]^2 + abs(q[i]))").structure.is_quadratic);
}

TEST_CASE("masses of Lagrangians of sums are found by the same derivatives") {
    const System system = chain("sum(i=1..N, (i + 1)*p[i]^2/2 - q[i]^4)", "lagrangian");
    CHECK(system.structure.has_diagonal_mass);
    for (const char* L :
         {"sum(i=1..N, p[i]^2/2 + abs(p[i]) - q[i]^4)", "sum(i=1..N, p[i]^2/2 + p[i] - q[i]^4)",
          "sum(i=1..N, p[i]^4 - q[i]^4)", "sum(i=1..N-1, (p[i] + p[i+1])^2 - q[i]^4)"}) {
        CAPTURE(L);
        CHECK_THROWS_AS(chain(L, "lagrangian"), NoLoops);
    }
}
