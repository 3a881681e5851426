// How much of a run a picture shows.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <vector>

#include <catch2/catch.hpp>

#include "generator/draw/density.hpp"
#include "generator/support/error.hpp"

using namespace hvi::gen;

namespace {

constexpr double pi = 3.14159265358979323846;

/// f at k/100 of a period, for so many periods.
template <class Function>
std::vector<double> periods(double count, Function f) {
    std::vector<double> values;
    for (int k = 0; k <= static_cast<int>(100 * count); ++k) values.push_back(f(2 * pi * k / 100));
    return values;
}

double cosine(double x) { return std::cos(x); }
double sine(double x) { return std::sin(x); }

}  // namespace

TEST_CASE("a curve is shown up to its turning points") {
    // The cosine turns at each half of a period, after the first row at k = 50, 100, ...: the third
    // of them is known to be one where the curve is back by 1/10, which takes acos(9/10).
    const std::vector<double> swings = periods(10, cosine);
    CHECK(rows_with_turns(swings, 0.1, 2) ==
          151 + static_cast<std::size_t>(std::floor(std::acos(0.9) / (2 * pi) * 100)));
    CHECK(rows_with_turns(swings, 0.1, 19) == swings.size());
    CHECK(rows_with_turns(swings, 0.1, 18) < swings.size());
    // Ripples are no turns.
    const auto rippled = [](double x) { return x + 0.05 * std::sin(40 * x); };
    CHECK(rows_with_turns(periods(3, rippled), 0.1, 0) == 301);
    CHECK(rows_with_turns(periods(3, rippled), 0.01, 0) < 20);
    CHECK(rows_with_turns({}, 0.1, 0) == 0);
    CHECK(rows_with_turns({std::nan(""), 0, 1, std::nan(""), 0}, 0.1, 1) == 5);
    CHECK(rows_with_turns({std::nan(""), 0, 1, std::nan(""), 0}, 0.1, 0) == 4);
}

TEST_CASE("a band has the range and the mean of each part") {
    const std::vector<double> x{0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
    const Band all = band(x, {5, 1, 3, 0, 0, 6, -1, 2, 2, 1}, 3);
    CHECK(all.x == std::vector<double>{1, 4, 7.5});
    CHECK(all.least == std::vector<double>{1, 0, -1});
    CHECK(all.most == std::vector<double>{5, 6, 2});
    CHECK(all.mean == std::vector<double>{3, 2, 1});

    const double none = std::nan(""), infinite = HUGE_VAL;
    const Band some = band({0, 1, 2, 3, 4, 5}, {none, 4, none, -infinite, infinite, 7}, 3);
    CHECK(some.x == std::vector<double>{0.5, 4.5});
    CHECK(some.least == std::vector<double>{4, 7});
    CHECK(some.most == std::vector<double>{4, 7});
    CHECK(some.mean == std::vector<double>{4, 7});
}

TEST_CASE("columns have an extent together") {
    CHECK(extent({{1, 2, std::nan("")}, {-3}}) == 5);
    CHECK(extent({}) == 0);
    CHECK(extent({{std::nan("")}}) == 0);
}

TEST_CASE("curves in the plane are shown as long as there is room") {
    // A circle crosses some 4 * 50 of 2500 cells, however often it is gone around.
    CHECK(rows_with_room({{periods(50, cosine), periods(50, sine)}}) == 5001);
    // A curve of Lissajous whose frequencies have no common period fills the square.
    const auto fast = [](double x) { return std::cos(std::sqrt(2) * x); };
    const std::size_t filled = rows_with_room({{periods(200, cosine), periods(200, fast)}});
    CHECK(filled < 4000);
    CHECK(filled > 300);
    CHECK(rows_with_room({}) == 0);
    CHECK(rows_with_room({{{1, 1, 1}, {2, 2, 2}}}) == 3);
    CHECK(rows_with_room({{{0, std::nan(""), 1}, {0, 1, 1}}}) == 3);
}

TEST_CASE("columns of a table are read by their number") {
    const auto file = std::filesystem::temp_directory_path() /
                      ("hvi-density-" + std::to_string(std::rand()) + ".csv");
    std::ofstream(file) << "t,\"u[1,2]\",x\n0,1.5,-2e-3\n1,nan,4\n# incomplete\n";
    const auto columns = read_columns(file, {3, 1, 2, 9});
    std::filesystem::remove(file);
    REQUIRE(columns.size() == 4);
    CHECK(columns[0] == std::vector<double>{-2e-3, 4});
    CHECK(columns[1] == std::vector<double>{0, 1});
    CHECK(columns[2][0] == 1.5);
    CHECK(std::isnan(columns[2][1]));
    CHECK(std::isnan(columns[3][0]));
    CHECK_THROWS_AS(read_columns(file, {1}), EnvironmentError);
}
