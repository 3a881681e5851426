// Runs of scenes whose definitions hold sums.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/program/simulate/scene_run.hpp"

using namespace hvi::test;

TEST_CASE("a sum in a definition goes as a loop as it goes written out") {
    const std::string chain =
        "coordinates = [\"x[1..N]\"]\nmomenta = [\"p[1..N]\"]\n"
        "hamiltonian = \"sum(i=1..N, p[i]^2/2) + bonds\"\n"
        "[parameters]\nN = 5\n"
        "[definitions]\nbonds = \"sum(i=1..N-1, 1 - cos(x[i+1] - x[i]))\"\n"
        "[initial]\n\"x[i]\" = \"sin(i)\"\n\"p[i]\" = 0\n"
        "[run]\nmethod = \"stormer-verlet\"\nstep = \"1/10\"\nuntil = 2\n";
    const std::vector<double> loops = run_scene(chain, "--unroll no").last();
    const std::vector<double> out = run_scene(chain, "--unroll yes").last();
    REQUIRE(loops.size() >= 11);
    REQUIRE(out.size() == loops.size());
    for (std::size_t k = 0; k < 11; ++k) {
        CAPTURE(k);
        CHECK(std::abs(loops[k] - out[k]) < 1e-13);
    }
}
