// Tableaux whose entries are rounded one by one.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>

#include <catch2/catch.hpp>

#include "generator/edges/rounded_tableau.hpp"
#include "generator/exact/methods/galerkin.hpp"
#include "generator/read/method.hpp"

using namespace hvi::gen;

namespace {

RoundedTableau rounded(const std::string& name) {
    return rounded_entries(
        derive(named_method(std::make_shared<const Source>(Source{"--method", name}))));
}

}  // namespace

TEST_CASE("entries that are doubles lose nothing") {
    const RoundedTableau midpoint = rounded("midpoint");
    CHECK(midpoint.words == std::vector<double>{1, 0.5, 0.5, 1});
    CHECK(midpoint.is_symplectic);
    const RoundedTableau verlet = rounded("stormer-verlet");
    CHECK(verlet.words == std::vector<double>{2, 0, 0, 0.5, 0.5, 0.5, 0, 0.5, 0, 0.5, 0.5});
    CHECK(verlet.is_symplectic);
}

TEST_CASE("entries that are rounded break the condition") {
    // 1/4 - sqrt(3)/6 and 1/4 + sqrt(3)/6, of Gauss: their sum is not 1/2 any more, as the smaller
    // one has four bits more after the point.
    const RoundedTableau gauss = rounded("gauss:2");
    REQUIRE(gauss.words.size() == 1 + 4 + 4 + 2);
    CHECK(gauss.words[2] == static_cast<double>(0.25L - std::sqrt(3.0L) / 6));
    CHECK_FALSE(gauss.is_symplectic);
    CHECK_FALSE(rounded("gauss:4").is_symplectic);
    // 1/6 and 2/3 are not doubles.
    CHECK_FALSE(rounded("lobatto:3").is_symplectic);
}
