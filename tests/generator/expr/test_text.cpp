// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "generator/expr/expression.hpp"
#include "generator/read/parse.hpp"
#include "tests/generator/read/refusal.hpp"

using namespace hvi::gen;

namespace {

std::string reprinted(const std::string& text) { return to_text(parse_expression(source(text))); }

}  // namespace

TEST_CASE("a text in its shortest form comes back as it was") {
    const std::string text =
        GENERATE(as<std::string>{}, "0", "1", "x", "-x", "-1/2", "2*pi", "x^2", "a/(b*c)",
                 "1/6-5*sqrt(2)/48", "(pi-2)/(2*pi)", "cos(2*pi*tau)", "a-b+c", "a-(b+c)", "-(a+b)",
                 "x^y^z", "(x^y)^z", "1/x", "1/x^2", "(a+b)*(c-d)", "bspline(3,1)", "-x/y-z",
                 "exp(-x)", "sqrt(3+2*sqrt(2))");
    CHECK(reprinted(text) == text);
}

TEST_CASE("parentheses and blanks that mean nothing are left out, and signs come first") {
    CHECK(reprinted(" ( a + ( b + c ) ) ") == "a+b+c");
    CHECK(reprinted("a*(b*c)") == "a*b*c");
    CHECK(reprinted("1*(a+b)") == "a+b");
    CHECK(reprinted("a+1*(b+c)-1*(b+c)") == "a+b+c-(b+c)");
    CHECK(reprinted("a+1/(1/(-b+c))") == "a-b+c");
    CHECK(reprinted("(1*x)^2+(--y)^2+(1/1)^n") == "x^2+y^2+1^n");
    CHECK(reprinted("sin(1*(a+b))") == "sin(a+b)");
    CHECK(reprinted("2^(1*(a+b))*2^-(a+b)") == "2^(a+b)*2^-(a+b)");
    CHECK(reprinted("a/b/c") == "a/(b*c)");
    CHECK(reprinted("a/(b/c)") == "a*c/b");
    CHECK(reprinted("a*-b") == "-a*b");
    CHECK(reprinted("-a/-b") == "a/b");
    CHECK(reprinted("--x") == "x");
    CHECK(reprinted("a--b") == "a+b");
    CHECK(reprinted("a-(-b)*c") == "a+b*c");
    CHECK(reprinted("+x") == "x");
    CHECK(reprinted("1*x") == "x");
}

TEST_CASE("a rational factor is written as its numerator and its denominator") {
    const Expression root = Expression::call("sqrt", {Expression::integer(2)});
    CHECK(to_text(Expression::product({Expression::rational("5", "48"), root})) == "5*sqrt(2)/48");
    CHECK(to_text(Expression::product({Expression::rational("1", "2"), root})) == "sqrt(2)/2");
    CHECK(to_text(Expression::reciprocal(Expression::rational("2", "3"))) == "3/2");
    CHECK(to_text(Expression::rational("1", "1")) == "1");
    CHECK(to_text(Expression::power(Expression::rational("2", "3"), root)) == "(2/3)^sqrt(2)");
    CHECK(to_text(Expression::sum({root, Expression::integer(-1)})) == "sqrt(2)-1");
}

TEST_CASE("a negated power is not a power of a negation") {
    const Expression x = Expression::symbol("x");
    const Expression two = Expression::integer(2);
    CHECK(to_text(Expression::power(Expression::negation(x), two)) == "(-x)^2");
    CHECK(to_text(Expression::negation(Expression::power(x, two))) == "-x^2");
    CHECK(parse_expression(source("-x^2")) == Expression::negation(Expression::power(x, two)));
}
