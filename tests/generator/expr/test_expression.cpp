// SPDX-License-Identifier: GPL-2.0-or-later
#include <limits>
#include <vector>

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

TEST_CASE("decimals are written as they were given") {
    const auto check = [](const std::string& text, const std::string& latex) {
        const Expression x = Expression::symbol("x");
        CHECK(to_text(Expression::product({Expression::decimal(text), x})) == text + "*x");
        CHECK(to_latex(Expression::decimal(text)) == latex);
    };
    check("0.25", "0.25");
    check("-12.50", "-12.50");
    check("3", "3");
    const Expression small = Expression::decimal("-1.5e-20");
    CHECK(to_text(small) == "-1.5*10^-20");
    CHECK(to_latex(small) == R"(-1.5 \cdot 10^{-20})");
    CHECK(Expression::decimal("0.25").numerator == "025");
    CHECK(Expression::decimal("0.25").denominator == "100");
    CHECK_THROWS_AS(Expression::decimal("0.2x"), InternalError);
}

TEST_CASE("symbols get other names, all at once") {
    const Expression x = Expression::symbol("x"), y = Expression::symbol("y");
    const Expression sum =
        Expression::sum({x, Expression::call("sin", {y}), Expression::power(y, x)});
    CHECK(to_text(renamed(sum, {{"x", "y"}, {"y", "x"}, {"sin", "cos"}})) == "y+sin(x)+x^y");
    CHECK(renamed(sum, {}) == sum);
}

TEST_CASE("expressions stand in the places of symbols, all at once, and stay flat") {
    const Expression x = Expression::symbol("x"), y = Expression::symbol("y");
    const Expression sum = Expression::sum({x, Expression::call("sin", {y})});
    const Expression other = replaced(sum, {{"x", Expression::sum({y, y})}, {"y", x}});
    CHECK(to_text(other) == "y+y+sin(x)");
    CHECK(other.arguments.size() == 3);
    CHECK(replaced(sum, {{"sin", x}}) == sum);
    // The index of a sum is another symbol within it, and the same in its bounds.
    const Expression two = Expression::integer(2);
    const Expression over = Expression::sum_over("x", Expression::integer(1), x, x);
    CHECK(replaced(over, {{"x", two}}) ==
          Expression::sum_over("x", Expression::integer(1), two, x));
    CHECK(has_sum(Expression::negation(over)));
    CHECK_FALSE(has_sum(sum));
}

TEST_CASE("one of two expressions comes first, unless they are equal") {
    const Expression x = Expression::symbol("x"), y = Expression::symbol("y"),
                     two = Expression::integer(2), ten = Expression::integer(10);
    const std::vector<Expression> in_order{
        two,
        Expression::product({two, x}),
        Expression::power(two, y),
        ten,
        Expression::integer(-10),
        x,
        Expression::sum({x, Expression::negation(y)}),
        Expression::product({x, y}),
        y,
        Expression::sum({y, Expression::negation(x)}),
    };
    for (std::size_t i = 0; i < in_order.size(); ++i)
        for (std::size_t j = 0; j < in_order.size(); ++j) {
            INFO(to_text(in_order[i]) << " and " << to_text(in_order[j]));
            CHECK(precedes(in_order[i], in_order[j]) == (i < j));
        }
}

TEST_CASE("words of an expression, however long its names are") {
    const auto words = [](const char* name) {
        return word_count(Expression::sum(
            {Expression::symbol(name), Expression::negation(Expression::integer(100))}));
    };
    CHECK(words("x") == 4);
    CHECK(words("momentum_of_the_first") == 4);
}

TEST_CASE("functions are found by name") {
    REQUIRE(find_function("bspline") != nullptr);
    CHECK(find_function("bspline")->arguments == 2);
    CHECK(find_function("atan2")->arguments == 2);
    CHECK(find_function("erf")->is_smooth());
    CHECK_FALSE(find_function("abs")->is_smooth());
    CHECK_FALSE(find_function("if<=")->is_smooth());
    CHECK(is_function("if"));
    CHECK(find_function("if") == nullptr);
    CHECK(find_function("Sin") == nullptr);
    CHECK(find_function("") == nullptr);
}
