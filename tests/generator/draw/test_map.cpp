// Pictures of studies: grids, points and their colours.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "generator/draw/full_grid.hpp"
#include "generator/draw/map.hpp"
#include "generator/draw/palette.hpp"
#include "generator/draw/pixels.hpp"

using namespace hvi::gen;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
const double no_number = std::nan("");

std::size_t times(const std::string& part, const std::string& text) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++count;
    return count;
}

/// A rectangle of one colour: its left edge and its lower one, in pixels from above.
struct Rectangle {
    std::string colour;
    double left = 0, bottom = 0;
};

/// The first rectangles, those of an image. NOTE: behind them are those of the scale of colours.
std::vector<Rectangle> rectangles(const std::string& svg, std::size_t count) {
    std::vector<Rectangle> result;
    const std::string begin = "<polygon fill = '", points = "points = '";
    for (std::size_t at = svg.find(begin); at != std::string::npos; at = svg.find(begin, at + 1)) {
        const std::size_t colour = at + begin.size();
        Rectangle one{svg.substr(colour, svg.find('\'', colour) - colour)};
        const std::size_t corner = svg.find(points, at) + points.size();
        REQUIRE(std::sscanf(svg.c_str() + corner, "%lf,%lf", &one.left, &one.bottom) == 2);
        result.push_back(one);
    }
    REQUIRE(result.size() > count);
    result.resize(count);
    return result;
}

// The ends and the middle of matplotlib's viridis.
const std::string darkest = "rgb( 68,   1,  84)", lightest = "rgb(253, 231,  37)",
                  middle = "rgb( 33, 145, 140)", grey_of_gaps = "rgb(176, 176, 176)";

MapPicture picture_of(std::vector<double> values, const std::string& z = "z") {
    return {"a title", "x", "y", z, std::move(values)};
}

/// So many points at random in the unit square, with x as their value.
std::vector<double> scattered(int count, bool has_values) {
    std::mt19937 random(1);
    const auto part = [&] { return static_cast<double>(random()) / 4294967296.0; };
    std::vector<double> values;
    for (int k = 0; k < count; ++k) {
        const double x = part(), y = part();
        values.insert(values.end(), {x, y});
        if (has_values) values.push_back(x);
    }
    return values;
}

}  // namespace

TEST_CASE("points in any order are a grid where none is missing") {
    const auto grid =
        full_grid({{2, 10, 5}, {1, 10, 4}, {1, 20, 6}, {2, 20, 7}, {3, 20, 9}, {3, 10, 8}});
    REQUIRE(grid);
    CHECK(grid->x == std::vector<double>{1, 2, 3});
    CHECK(grid->y == std::vector<double>{10, 20});
    CHECK(grid->values == std::vector<double>{4, 5, 8, 6, 7, 9});
    CHECK(!full_grid({}));
    CHECK(!full_grid({{0, 0, 1}, {0, 1, 1}, {1, 0, 1}}));
    CHECK(!full_grid({{0, 0, 1}, {0, 1, 1}, {1, 0, 1}, {1, 0, 1}}));
    CHECK(!full_grid({{0, 0, 1}, {1, 0, 1}, {2, 0, 1}}));
    CHECK(!full_grid({{0, 0, 1}, {1, 0, 1}, {3, 0, 1}, {0, 1, 1}, {1, 1, 1}, {3, 1, 1}}));
    std::vector<MapPoint> rounded;
    for (const double y : {0.0, 1.0})
        for (int k = 0; k < 11; ++k) rounded.push_back({0.1 * k, y, 1});
    CHECK(full_grid(rounded));
}

TEST_CASE("of a large grid some points are shown") {
    FullGrid grid{{0, 1, 2, 3, 4}, {0, 1, 2}, {}};
    for (int k = 0; k < 15; ++k) grid.values.push_back(k);
    const FullGrid thin = thinned(grid, 3);
    CHECK(thin.x == std::vector<double>{0, 2, 4});
    CHECK(thin.y == std::vector<double>{0, 1, 2});
    CHECK(thin.values == std::vector<double>{0, 2, 4, 5, 7, 9, 10, 12, 14});
}

TEST_CASE("points are counted on pixels, and their values have a mean") {
    const Pixels all = pixels(
        {{0, 0, 1}, {0.1, 0.1, 3}, {0.2, 0, no_number}, {1, 1, no_number}, {0.9, 0, 5}}, 2, 2);
    CHECK(all.x.to == 1);
    CHECK(all.counts == std::vector<double>{3, 1, 0, 1});
    CHECK(all.means[0] == 2);
    CHECK(all.means[1] == 5);
    CHECK(std::isnan(all.means[2]));
    CHECK(std::isnan(all.means[3]));
}

TEST_CASE("a range has a length") {
    CHECK(range_of({no_number, 2, -1, infinite}).from == -1);
    CHECK(range_of({no_number, 2, -1, infinite}).to == 2);
    CHECK(range_of({4, 4}).from == 2);
    CHECK(range_of({4, 4}).to == 6);
    CHECK(range_of({0}).from == -1);
    CHECK(range_of({}).to == 1);
}

TEST_CASE("a few values that are far away do not take the colours of the others") {
    std::vector<double> numbers;
    for (int i = 0; i < 1000; ++i) numbers.push_back(i);
    CHECK(colour_range_of(numbers).from == 0);
    CHECK(colour_range_of(numbers).to == 999);
    numbers[7] = 1e6;
    numbers[8] = -1e5;
    numbers[9] = no_number;
    CHECK((10 <= colour_range_of(numbers).from && colour_range_of(numbers).from <= 20));
    CHECK((980 <= colour_range_of(numbers).to && colour_range_of(numbers).to <= 999));
    // All but a few are equal: there is no other range than that of all.
    CHECK(colour_range_of([] {
              std::vector<double> equal(500, 1.0);
              equal[3] = 9;
              return equal;
          }())
              .to == 9);

    std::vector<double> values;
    for (int i = 0; i < 40; ++i)
        for (int j = 0; j < 40; ++j)
            values.insert(values.end(), {i / 39.0, j / 39.0, i == 5 && j < 3 ? 1e9 : i});
    const std::string svg = draw(picture_of(values));
    std::set<std::string> colours;
    for (const Rectangle& one : rectangles(svg, 1600)) colours.insert(one.colour);
    CHECK(colours.size() >= 38);
    CHECK(svg.find("with 1 % beyond each end") != std::string::npos);
    CHECK(draw(picture_of({0, 0, 1, 0, 1, 1, 1, 0, 1, 1, 1, 1})).find("beyond") ==
          std::string::npos);
}

TEST_CASE("a grid is an image, with the least value dark and gaps grey") {
    // x to the right and y up.
    const std::string svg = draw(picture_of({0, 0, -1, 1, 0, 0, 2, 0, 1,  //
                                             0, 1, 1, 1, 1, no_number, 2, 1, infinite}));
    const std::vector<Rectangle> all = rectangles(svg, 6);
    const auto at = [&](double column, double row) {
        const double width = 523, height = 500;
        for (const Rectangle& one : all)
            if (std::abs(one.left - all.front().left - column * width / 3) < 20 &&
                std::abs(all.front().bottom - one.bottom - row * height / 2) < 20)
                return one.colour;
        return std::string();
    };
    CHECK(at(0, 0) == darkest);
    CHECK(at(1, 0) == middle);
    CHECK(at(2, 0) == lightest);
    CHECK(at(0, 1) == lightest);
    CHECK(at(1, 1) == grey_of_gaps);
    CHECK(at(2, 1) == grey_of_gaps);
    for (const std::string word : {"a title", ">x<", ">y<", ">z<"})
        CHECK(svg.find(word) != std::string::npos);
}

TEST_CASE("a grid without gaps has no grey") {
    const std::string svg = draw(picture_of({0, 0, 1, 0, 1, 1, 1, 0, 1, 1, 1, 1}));
    for (const Rectangle& one : rectangles(svg, 4)) CHECK(one.colour == middle);
    CHECK(svg.find(grey_of_gaps) == std::string::npos);
}

TEST_CASE("a large grid is a picture in one piece") {
    std::vector<double> values;
    for (int i = 0; i < 300; ++i)
        for (int j = 0; j < 300; ++j)
            values.insert(values.end(), {i / 299.0, j / 299.0, i < 30 ? no_number : i * j});
    const std::string svg = draw(picture_of(values));
    CHECK(times("<image", svg) == 1);
    CHECK(svg.find("data:image/png;base64,") != std::string::npos);
    CHECK(svg.size() < 500'000);
    CHECK(draw(picture_of(values)) == svg);
}

TEST_CASE("points that are no grid are dots in the colours of their values") {
    const std::string svg = draw(picture_of(
        {0, 0, -1, 1, 0.5, 0, 3, 1, 1, 2, 2, no_number, no_number, 1, 1, infinite, 2, 3}));
    CHECK(times("<use xlink:href='#gpPt6' transform='translate(", svg) == 4);
    for (const std::string& colour : {darkest, middle, lightest, grey_of_gaps})
        CHECK(svg.find("color='" + colour + "'/>") != std::string::npos);
    CHECK(draw(picture_of({1, 2, no_number})).find(grey_of_gaps) != std::string::npos);
    CHECK(draw(picture_of({no_number, 2, 3})).find("a title") != std::string::npos);
    CHECK(draw(picture_of({-1e308, 0, 1, 1e308, 0, 1})).find("a title") != std::string::npos);
}

TEST_CASE("points without values are dots of one colour") {
    const std::string svg = draw(picture_of({0, 0, 1, 1, 2, 5, no_number, 1}, ""));
    CHECK(times("<use xlink:href='#gpPt6' transform='translate(", svg) == 3);
    CHECK(svg.find("fill='rgb( 68,   1,  84)'") == std::string::npos);
    const std::string all = draw(picture_of(scattered(20'000, false), ""));
    CHECK(times("<use xlink:href='#gpPt6' transform='translate(", all) == 20'000);
    CHECK(all.size() < 3'000'000);
}

TEST_CASE("very many points are a picture in one piece") {
    for (const bool has_values : {false, true}) {
        const MapPicture picture =
            picture_of(scattered(100'000, has_values), has_values ? "z" : "");
        const std::string svg = draw(picture);
        CHECK(times("<image", svg) == 1);
        CHECK(svg.size() < 2'000'000);
        CHECK((svg.find("points in a pixel") == std::string::npos) == has_values);
        CHECK(draw(picture) == svg);
    }
}
