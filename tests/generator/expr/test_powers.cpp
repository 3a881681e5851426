// Equal factors as powers.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "generator/expr/powers.hpp"
#include "generator/read/parse.hpp"
#include "tests/generator/read/refusal.hpp"

using namespace hvi::gen;

TEST_CASE("equal factors come once") {
    const auto text = [](const std::string& given) {
        return to_text(with_powers(parse_expression(source(given))));
    };
    CHECK(text("x*y*x") == "x^2*y");
    CHECK(text("x^2*x*x^3") == "x^6");
    CHECK(text("a/((x-y)*(x-y)*sqrt((x-y)*(x-y)))") == "a/((x-y)^2*sqrt((x-y)^2))");
    CHECK(text("2*x*2") == "2*x*2");
    CHECK(text("x^w*x^w + x*x") == "(x^w)^2+x^2");
    CHECK(text("x^100*x") == "x^100*x");
    CHECK(text("x^(1/2)*x") == "x^(1/2)*x");
}
