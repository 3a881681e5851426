// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "generator/render/stability_svg.hpp"
#include "tests/generator/render/tableaux.hpp"

using namespace hvi::gen;

namespace {

std::string picture(const Tableau& tableau, const std::string& name) {
    const OscillatorMap map = oscillator_map(tableau);
    return stability_svg(name, map, linear_stability(map, 20));
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at) { ++found; }
    return found;
}

}  // namespace

TEST_CASE("a picture shows intervals, poles and the curve between them") {
    const std::string svg = picture(tableau("trig3"), "trig3");
    CHECK(svg.rfind("<svg xmlns=\"http://www.w3.org/2000/svg\"", 0) == 0);
    CHECK(svg.substr(svg.size() - 7) == "</svg>\n");
    CHECK(count(svg, "class=\"stable\"") == 2);
    CHECK(count(svg, "class=\"pole\"") == 1 + 1);  // the legend has one
    CHECK(count(svg, "pole 7.381") == 1);
    CHECK(count(svg, "Stable for z in (0, 2.37351), (3.31779, 3.9374)<") == 1);
    const std::string path = svg.substr(svg.find("<path"));
    CHECK(count(path, "M") == 2);  // one branch on either side of the pole
    CHECK(count(svg, "nan") + count(svg, "inf") == 0);
}

TEST_CASE("touching points are marked") {
    const std::string svg = picture(tableau("gauss:4"), "gauss:4");
    CHECK(count(svg, "class=\"identity\"") == 3 + 1);
    CHECK(count(svg, "class=\"pole\"") == 0);
    CHECK(count(svg, "No poles") == 1);
}

TEST_CASE("a picture is the same each time, and its text is escaped") {
    const Tableau method = tableau("chebyshev:3");
    CHECK(picture(method, "a < b & c") == picture(method, "a < b & c"));
    CHECK(count(picture(method, "a < b & c"), "a &lt; b &amp; c") == 2);
}
