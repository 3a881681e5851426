// SPDX-License-Identifier: GPL-2.0-or-later
#include <limits>

#include <catch2/catch.hpp>

#include "generator/expr/expression.hpp"
#include "generator/expr/functions.hpp"

using namespace hvi::gen;
using Kind = Expression::Kind;

TEST_CASE("an integer below zero is a negation") {
    CHECK(Expression::integer(7) == Expression::rational("7", "1"));
    CHECK(Expression::integer(-7) == Expression::negation(Expression::integer(7)));
    const Expression least = Expression::integer(std::numeric_limits<long>::min());
    CHECK(least.kind == Kind::negation);
    CHECK(least.arguments[0].numerator.front() != '-');
}

TEST_CASE("sums and products are flat, and need at least two arguments") {
    const Expression x = Expression::symbol("x");
    const Expression y = Expression::symbol("y");
    CHECK(Expression::sum({}) == Expression::integer(0));
    CHECK(Expression::sum({x}) == x);
    CHECK(Expression::product({}) == Expression::integer(1));
    CHECK(Expression::product({y}) == y);
    CHECK(Expression::sum({Expression::sum({x, y}), x}) == Expression::sum({x, y, x}));
    CHECK(Expression::product({x, Expression::product({x, y})}) == Expression::product({x, x, y}));
    CHECK(Expression::sum({Expression::product({x, y}), x}).arguments.size() == 2);
}

TEST_CASE("equality looks at the tree and not at the ranges") {
    Expression here = Expression::symbol("x");
    Expression there = here;
    there.range = {3, 4};
    CHECK(here == there);
    CHECK_FALSE(here == Expression::symbol("y"));
    CHECK_FALSE(Expression::sum({here, here}) == Expression::product({here, here}));
    CHECK_FALSE(Expression::rational("1", "2") == Expression::rational("2", "4"));
    CHECK_FALSE(Expression::call("sin", {here}) == Expression::call("cos", {here}));
}

TEST_CASE("broken invariants are refused") {
    CHECK_THROWS_AS(Expression::rational("-1", "2"), InternalError);
    CHECK_THROWS_AS(Expression::rational("1", "00"), InternalError);
    CHECK_THROWS_AS(Expression::rational("", "1"), InternalError);
    CHECK_THROWS_AS(Expression::call("sin", {}), InternalError);
}

TEST_CASE("functions are found by name") {
    REQUIRE(find_function("bspline") != nullptr);
    CHECK(find_function("bspline")->arguments == 2);
    CHECK(find_function("Sin") == nullptr);
    CHECK(find_function("") == nullptr);
}
