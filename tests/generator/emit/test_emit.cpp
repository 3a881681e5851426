// Texts of headers. Tests in tests/runtime/run run them.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cstdlib>
#include <regex>
#include <sstream>
#include <string>

#include <catch2/catch.hpp>

#include "generator/emit/steps/emit.hpp"
#include "generator/emit/text/text.hpp"
#include "generator/plan/plan.hpp"
#include "generator/support/error.hpp"
#include "tests/generator/emit/header.hpp"
#include "tests/generator/exact/exact.hpp"
#include "tests/generator/plan/tableaux.hpp"

using namespace hvi::gen;
using Catch::Matchers::Contains;

namespace {

std::string from_class(const std::string& text) {
    return text.substr(text.find("\nnamespace hvi::generated"));
}

/// Replaces adjacent blanks by one.
std::string in_one_line(const std::string& text) {
    return std::regex_replace(text, std::regex("\\s+"), " ");
}

}  // namespace

TEST_CASE("an explicit header includes the standard library alone") {
    for (const auto& tableau :
         {tableaux::symplectic_euler(), tableaux::verlet(), tableaux::position_verlet()}) {
        const std::string text = header(tableau, true);
        CHECK_THAT(text, !Contains("#include <hvi"));
        CHECK_THAT(text, !Contains("#include \""));
        CHECK_THAT(text, Contains("#ifndef HVI_STATE_HPP"));
    }
}

TEST_CASE("zeros and ones leave no trace in the arithmetic") {
    for (const bool separable : {false, true}) {
        const std::string lobatto = from_class(header(tableaux::lobatto_3(), separable));
        // Row 1 of m is 0, row 3 is 1; column 3 of mt is 0, column 1 is 1.
        CHECK_THAT(lobatto, !Contains("m[0][") && !Contains("m[2]["));
        CHECK_THAT(lobatto, !Contains("[2] * s.Lp[2]") && !Contains("[0] * s.Lp[0]"));
        CHECK_THAT(in_one_line(lobatto), Contains("m[1][0] * s.Lq[0][k] + m[1][1] * s.Lq[1][k]"));
    }
    const std::string euler = from_class(header(tableaux::symplectic_euler(), true));
    CHECK_THAT(euler, !Contains("b_p") && !Contains("b_q") && !Contains("1.0"));
    CHECK_THAT(euler, Contains("p[k] = x.p[k] - h * slope[k];"));
}

TEST_CASE("a stage that needs no solver gets none") {
    const std::string verlet = from_class(header(tableaux::verlet(), true));
    CHECK_THAT(verlet, !Contains("solve"));
    CHECK_THAT(verlet, Contains("known_ = false;"));
    const std::string two = from_class(header(tableaux::two_midpoints(), false));
    CHECK_THAT(two, Contains("solver_[0].solve(Coupled1{system_, s_})"));
    CHECK_THAT(two, Contains("solver_[1].solve(Coupled2{system_, s_})"));
}

TEST_CASE("a header says what made it and from what") {
    const std::string text = header(tableaux::negative_weight(), false);
    CHECK(text.rfind("// Written by hvi-gen ", 0) == 0);
    CHECK_THAT(text, Contains("//     hvi-gen stepper --method by-hand\n"));
    CHECK_THAT(text, Contains("// SPDX-License-Identifier: MIT\n"));
    CHECK_THAT(text, Contains("//     b_2 = -1/3\n"));
    CHECK_THAT(text, Contains("//     a_1,1 = 23/48\n"));
    CHECK_THAT(text, Contains("Negative weights: b_2."));
    CHECK_THAT(text, Contains("static_assert(hvi::detail::complementary(m, mt)"));
    CHECK_THAT(text, Contains("// b_2 = -1/3\n"));
}

TEST_CASE("the text of a header is well laid out") {
    for (const auto& tableau :
         {tableaux::lobatto_3(), tableaux::verlet(), tableaux::two_midpoints(),
          tableaux::negative_weight(), tableaux::position_verlet(),
          derive(method("1, cos(pi*w*tau), exp(w*tau)", "0, 1/2, 1"))}) {
        for (const bool separable : {false, true}) {
            std::istringstream text(header(tableau, separable));
            std::string line, last;
            while (std::getline(text, line)) {
                CHECK(line.size() <= page_width);
                CHECK((line.empty() || line.back() != ' '));
                CHECK((line.empty() || line.find('@') == std::string::npos));
                CHECK_FALSE((line.empty() && last.empty()));
                last = line;
            }
        }
    }
}

TEST_CASE("a command cannot end its comment") {
    const std::string text = emit({tableaux::midpoint()}, plan({tableaux::midpoint()}, {}),
                                  {"Method", "hvi-gen stepper --method \"a\nint x;\\"});
    CHECK_THAT(text, !Contains("\nint x;"));
    CHECK_THAT(text, !Contains("\\\n"));
}

TEST_CASE("literals read back as the same number") {
    for (const double value : {1.0, -0.5, 1.0 / 3, 1e22, 5e-324, 0.1, -123456789.125, 0.0}) {
        CHECK(std::strtod(literal(value).c_str(), nullptr) == value);
        CHECK(literal(value).find_first_of(".e") != std::string::npos);
    }
    for (const float value : {1.0F, 1.0F / 3, 1e30F, -0x1p-149F, 16777216.0F}) {
        CHECK(std::strtof(literal(value).c_str(), nullptr) == value);
        CHECK(literal(value).back() == 'f');
    }
    CHECK(literal(1.0) == "1.0");
    CHECK(literal(1.0 / 3) == "0.3333333333333333");
}

TEST_CASE("long statements and comments are broken to the page") {
    Writer writer(1);
    std::string sum = "a0";
    for (int i = 1; i < 60; ++i) { sum += fmt::format(" + a{}", i); }
    writer.line("const double x = {};", sum).comment(std::string(300, '7'));
    std::istringstream text(writer.str());
    std::string line;
    while (std::getline(text, line)) { CHECK(line.size() + 4 <= page_width); }
}

TEST_CASE("holes that are unknown, missing or not used break an invariant") {
    CHECK_THROWS_AS(fill("banner.hpp.in", {}), InternalError);
    const Holes holes{{"version", "1"}, {"command", "c"}, {"method", "m"},
                      {"numbers", "t"}, {"scene", ""},    {"choices", ""}};
    CHECK_NOTHROW(fill("banner.hpp.in", holes));
    Holes more = holes;
    more["surplus"] = "x";
    CHECK_THROWS_AS(fill("banner.hpp.in", more), InternalError);
    CHECK_THROWS_AS(fill("no such template", holes), InternalError);
}
