// Evenly spaced values.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <string>

#include <catch2/catch.hpp>

#include "generator/ensembles/grid.hpp"
#include "tests/generator/ensembles/scene_of_options.hpp"
#include "tests/generator/read/refusal.hpp"

using namespace hvi::gen;

namespace {

Grid read_grid(const std::string& text) { return grid(given("--vary", text), scene_of_options()); }

Refusal grid_refused(const std::string& text) {
    return refusal([&] { return read_grid(text); });
}

}  // namespace

TEST_CASE("a grid has both ends and what is evenly between") {
    const Grid tenths = read_grid("x=0:1:11");
    CHECK(tenths.name == "x");
    CHECK(tenths.count == 11);
    CHECK(tenths.place.range.end == 1);
    for (int k = 0; k <= 10; ++k) CHECK(tenths.at(k) == k / 10.0);
    const Grid back = read_grid(" u[1,2] = m[2]*w : -w : 4 ");
    CHECK(back.name == "u[1,2]");
    CHECK(back.at(0) == static_cast<double>(std::sqrt(2.0L) / 3));
    CHECK(back.at(3) == -1.0 / 3);
    CHECK(back.at(1) == Approx((2 * std::sqrt(2.0) - 1) / 9).epsilon(1e-15));
}

TEST_CASE("ends of a grid are hit to the bit, whatever is between") {
    const Grid wide = read_grid("x=-10^308:10^308:3");
    CHECK(wide.at(0) == -1e308);
    CHECK(wide.at(1) == 0);
    CHECK(wide.at(2) == 1e308);
    const Grid uneven = read_grid("x=10^20:1/10:7");
    CHECK(uneven.at(0) == 1e20);
    CHECK(uneven.at(6) == 0.1);
}

TEST_CASE("a grid of one value has the first end") {
    const Grid alone = read_grid("x=2:5:1");
    CHECK(alone.count == 1);
    CHECK(alone.at(0) == 2);
    const Grid constant = read_grid("x=w:w:3");
    for (int k = 0; k < 3; ++k) CHECK(constant.at(k) == 1.0 / 3);
}

TEST_CASE("what is wrong with a grid is said where it is") {
    const Refusal parts = grid_refused("x=0:1");
    CHECK(parts.status == 2);
    CHECK(parts.what == "FROM:TO:COUNT is wanted here");
    CHECK(parts.marked == "x=[0:1]");
    CHECK(parts.helps("--vary x=0:1:101"));
    CHECK(grid_refused("x=0:1:2:3").marked == "x=[0:1:2:3]");
    CHECK(grid_refused("0:1:2").what == "NAME=FROM:TO:COUNT is wanted here");
    CHECK(grid_refused(" =0:1:2").what == "NAME=FROM:TO:COUNT is wanted here");
    for (const std::string count : {"0", "-1", "1.5", "", "n", "1000000001"})
        CHECK(grid_refused("x=0:1:" + count).marked == "x=0:1:[" + count + "]");
    CHECK(grid_refused("x=0:1: 2 3").marked == "x=0:1: [2 3]");
    const Refusal word = grid_refused("x=0:v*2:3");
    CHECK(word.what == "the scene has no parameter `v`");
    CHECK(word.marked == "x=0:[v]*2:3");
    CHECK(grid_refused("x=0:1/0:3").status == 2);
    CHECK(grid_refused("x=:1:3").status == 2);
    CHECK(grid_refused("x=0:10^400:3").what == "this number is beyond the range of doubles");
    CHECK(grid_refused("x=0:10^400:3").marked == "x=0:[10^400]:3");
}
