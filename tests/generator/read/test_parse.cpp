// SPDX-License-Identifier: GPL-2.0-or-later
#include <limits>

#include <catch2/catch.hpp>

#include "generator/read/parse.hpp"
#include "tests/generator/read/refusal.hpp"

using namespace hvi::gen;

namespace {

Refusal refused_expression(const std::string& text) {
    return refusal([&] { return parse_expression(source(text)); });
}

Refusal refused_list(const std::string& text) {
    return refusal([&] { return parse_list(source(text)); });
}

Expression number(long value) { return Expression::integer(value); }

}  // namespace

TEST_CASE("the grammar") {
    const Expression x = Expression::symbol("x");
    const auto read = [](const std::string& text) { return parse_expression(source(text)); };
    CHECK(read("1-x") == Expression::sum({number(1), Expression::negation(x)}));
    CHECK(read("2*x/3") == Expression::product({number(2), x, Expression::reciprocal(number(3))}));
    CHECK(read("-x^2") == Expression::negation(Expression::power(x, number(2))));
    CHECK(read("2^-3") == Expression::power(number(2), number(-3)));
    CHECK(read("x^2^3") == Expression::power(x, Expression::power(number(2), number(3))));
    CHECK(read("-x*2") == Expression::product({Expression::negation(x), number(2)}));
    CHECK(read("sin ( x )") == Expression::call("sin", {x}));
    CHECK(read("bspline(2, 1)") == Expression::call("bspline", {number(2), number(1)}));
    CHECK(read("\t( x )\r\n") == x);
    CHECK(read("1/0") == Expression::product({number(1), Expression::reciprocal(number(0))}));
}

TEST_CASE("expressions know where they stand") {
    const Expression sum = parse_expression(source("  1 + cos( pi*tau )"));
    CHECK(sum.range.begin == 2);
    CHECK(sum.range.end == 19);
    const Expression& call = sum.arguments[1];
    CHECK(call.range.begin == 6);
    CHECK(call.arguments[0].range.begin == 11);
    CHECK(call.arguments[0].range.end == 17);
    CHECK(call.arguments[0].arguments[1].range.begin == 14);
    CHECK(parse_expression(source("1 - x")).arguments[1].range.begin == 2);
    CHECK(parse_expression(source("2 /x")).arguments[1].range.begin == 2);
}

TEST_CASE("a part of a source is read with places in the whole") {
    const auto text = source("w=2tau");
    CHECK(refusal([&] { return parse_expression(text, {2, 6}); }).marked == "w=2[tau]");
    CHECK(parse_expression(text, {2, 3}) == number(2));
}

TEST_CASE("errors of operands and operators point at their place") {
    CHECK(refused_expression("").says("empty"));
    CHECK(refused_expression("  ").says("empty"));
    CHECK(refused_expression("1+").marked == "1+[]");
    CHECK(refused_expression("*2").marked == "[*]2");
    CHECK(refused_expression("1+*2").marked == "1+[*]2");
    CHECK(refused_expression("()").marked == "([)]");
    CHECK(refused_expression("2tau").marked == "2[tau]");
    CHECK(refused_expression("2tau").helps("`2*tau`"));
    CHECK(refused_expression("2(tau)").marked == "2[(]tau)");
    CHECK(refused_expression("2(tau)").helps("`2*(...)`"));
    CHECK(refused_expression("(a)(b)").helps("`(...)*(...)`"));
    CHECK(refused_expression("tau 2").marked == "tau [2]");
    CHECK(refused_expression("2e").helps("`2*e`"));
    CHECK(refused_expression("1.5.2").says("a number follows a number"));
    CHECK(refused_expression("x**2").marked == "x[**]2");
    CHECK(refused_expression("x**2").helps("`^`"));
    CHECK(refused_expression("1,2").marked == "1[,]2");
    CHECK(refused_expression("1,5").helps("0.5"));
}

TEST_CASE("errors of parentheses point at the one without a partner") {
    CHECK(refused_expression("(1+2").marked == "[(]1+2");
    CHECK(refused_expression("sin(1+(2)").marked == "sin[(]1+(2)");
    CHECK(refused_expression("1+2)").marked == "1+2[)]");
    CHECK(refused_list("1, 2)").marked == "1, 2[)]");
    CHECK(refused_expression("(1,2)").marked == "(1[,]2)");
}

TEST_CASE("errors of functions") {
    CHECK(refused_expression("sine(x)").marked == "[sine](x)");
    CHECK(refused_expression("sine(x)").helps("`sin`"));
    CHECK(refused_expression("foo(x)").helps("sqrt, exp, log"));
    CHECK(refused_expression("tau(2)").helps("tau*(...)"));
    // Where a function would be refused it is not offered.
    CHECK_FALSE(refused_expression("foo(x)").helps("roots"));
    CHECK_FALSE(refused_expression("foo(x)").helps("bspline"));
    CHECK_FALSE(refused_expression("rots(x)").helps("did you mean"));
    CHECK_FALSE(refusal([] { return parse_indexed_expression(source("foo(x)")); }).helps("roots"));
    CHECK(refusal([] { return parse_list(source("rots(x)")); }).helps("`roots`"));
    CHECK(refused_expression("sin").marked == "[sin]");
    CHECK(refused_expression("sin()").marked == "[sin()]");
    CHECK(refused_expression("1+sin(1,2)").marked == "1+[sin(1,2)]");
    CHECK(refused_expression("bspline(1)").says("2 arguments, not 1"));
}

TEST_CASE("characters that mean nothing are shown sanely") {
    CHECK(refused_expression("1#2").marked == "1[#]2");
    CHECK(refused_expression("2*\u03c0").marked == "2*[\u03c0]");
    CHECK(refused_expression("2*\u03c0").helps("`pi`"));
    CHECK(refused_expression("1\u22122").helps("`-`"));
    CHECK(refused_expression("gauss :3+1").says("`:`"));
    CHECK(refused_expression(std::string("1\0", 2)).says("0x00"));
    CHECK(refused_expression("1\x1b[2J").says("0x1b"));
    CHECK(refused_expression("\xff\xfe").says("0xff"));
    CHECK(refused_expression("\xcf").says("0xcf"));
    CHECK(refused_expression("x=2").marked == "x[=]2");
    CHECK(refused_expression(".").marked == "[.]");
}

TEST_CASE("length and depth are limited, and long flat texts are not deep") {
    CHECK(refused_expression(std::string(64 * 1024 + 1, '1')).says("64 KiB"));
    std::string flat = "1";
    while (flat.size() < 60000) flat += "+x*2-y/3";
    CHECK(refused_expression(flat).status == 0);
    const auto nested = [](const char* open, std::size_t depth, const char* close) {
        std::string text = "x";
        for (std::size_t k = 0; k < depth; ++k) text = open + text + close;
        return text;
    };
    CHECK(refused_expression(nested("(", 199, ")")).status == 0);
    CHECK(refused_expression(nested("(", 200, ")")).says("deeper than 200"));
    CHECK(refused_expression(nested("-", 20000, "")).says("deeper than 200"));
    CHECK(refused_expression(nested("2^", 20000, "")).says("deeper than 200"));
    CHECK(refused_expression(nested("sin(", 10000, ")")).says("deeper than 200"));
    CHECK(refused_expression(std::string(60000, '(')).says("deeper than 200"));
}

TEST_CASE("lists of expressions and families") {
    const List list = parse_list(source("radau-left:2 , a-b, gauss :03,sin(1)"));
    REQUIRE(list.items.size() == 4);
    const Family& left = std::get<Family>(list.items[0].what);
    CHECK(left.name == "radau-left");
    CHECK(left.size == 2);
    CHECK(left.range.begin == 0);
    CHECK(left.range.end == 12);
    CHECK(to_text(std::get<Expression>(list.items[1].what)) == "a-b");
    CHECK(std::get<Family>(list.items[2].what).size == 3);
    CHECK(list.items[3].range.begin == 30);
    CHECK(list.place(list.items[3].range).source->text == list.source->text);
}

TEST_CASE("a comma within a call does not end an item") {
    CHECK(parse_list(source("bspline(2,1),bspline(2,2)")).items.size() == 2);
}

TEST_CASE("errors of lists") {
    CHECK(refused_list("").says("empty"));
    CHECK(refused_list("1,").marked == "1[,]");
    CHECK(refused_list(",1").marked == "[,]1");
    CHECK(refused_list("1,,2").marked == "1,[,]2");
    CHECK(refused_list("1, ").says("missing after"));
    CHECK(refused_list("1 2").helps("commas"));
}

TEST_CASE("errors of families") {
    CHECK(refused_list("gauss:").marked == "gauss[:]");
    CHECK(refused_list("gauss:,1").marked == "gauss[:],1");
    CHECK(refused_list("1, gauss:-1").marked == "1, gauss:[-1]");
    CHECK(refused_list("gauss:x").marked == "gauss:[x]");
    CHECK(refused_list("gauss:3.5").marked == "gauss:[3.5]");
    CHECK(refused_list("gauss:3 + 1, 2").marked == "gauss:[3 + 1], 2");
    CHECK(refused_list("2*gauss:3").marked == "2*gauss[:]3");
    CHECK(refused_list("2*gauss:3").helps("stands alone"));
}

TEST_CASE("a lone family, with a size of any length") {
    CHECK(parse_family(source("gauss:3")).size == 3);
    CHECK(parse_family(source("gauss:99999999999999999999")).size ==
          std::numeric_limits<long>::max());
    CHECK(parse_family(source("gauss:000000000000000000000002")).size == 2);
    CHECK(refusal([] { return parse_family(source("gauss:3, 1")); }).status == 2);
    CHECK(refusal([] { return parse_family(source("gauss")); }).status == 2);
}
