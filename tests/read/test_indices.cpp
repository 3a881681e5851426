// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "generator/read/parse.hpp"
#include "tests/read/refusal.hpp"

using namespace hvi::gen;

namespace {

std::string expanded(const std::string& text) {
    return to_text(parse_indexed_expression(source(text)));
}

std::vector<std::string> names(const std::string& text) {
    std::vector<std::string> result;
    for (const Name& name : parse_names(source(text))) { result.push_back(name.text); }
    return result;
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("sums over an index are expanded") {
    CHECK(expanded("sum(i=1..3, x[i]^2)/2") == "(x[1]^2+x[2]^2+x[3]^2)/2");
    CHECK(expanded("sum(i=1..2, sum(j=i+1..3, m[i]*m[j]))") == "m[1]*m[2]+m[1]*m[3]+m[2]*m[3]");
    CHECK(expanded("sum(i=2..2, i*x[2*i-1])") == "2*x[3]");
    CHECK(expanded("sum(i=-1..0, x[i])") == "x[-1]+x[0]");
    CHECK(expanded("-sum(i=1..2, x[i])*2") == "-(x[1]+x[2])*2");
    CHECK(expanded("sum(i=1..2, x[i]) + sum(i=1..2, y[i])") == "x[1]+x[2]+y[1]+y[2]");
    CHECK(expanded("x[1+1]-1.5") == "x[2]-3/2");
    CHECK(expanded("sin(x[1])") == "sin(x[1])");
}

TEST_CASE("names with a range of indices are all of them") {
    CHECK(names("q") == Names{"q"});
    CHECK(names("x[1..3], y") == Names{"x[1]", "x[2]", "x[3]", "y"});
    CHECK(names(" x[0..0] ") == Names{"x[0]"});
    CHECK(names("x[7], x[-1], y") == Names{"x[7]", "x[-1]", "y"});
    CHECK(names("x[1..1000]").size() == 1000);
}

TEST_CASE("what is wrong with indices is said where it is") {
    const auto refused = [](const std::string& text) {
        const Refusal error = refusal([&] { return parse_indexed_expression(source(text)); });
        return error.marked + ": " + error.what;
    };
    CHECK(refused("x[1/2]") == "x[[1/2]]: a whole number is wanted here");
    CHECK(refused("x[i]") == "x[[i]]: a whole number is wanted here");
    CHECK(refused("x[1") == "x[1[]: `]` is wanted here");
    CHECK(refused("sum(i=1..2 x[i])") == "sum(i=1..2 [x][i]): an operator is missing before this");
    CHECK(refused("sum(i=1..2)") ==
          "sum(i=1..2[)]: a comma and the term of the sum are wanted here");
    CHECK(refused("sum(i=3..1, x[i])") == "sum([i=3..1], x[i]): this sum has no term");
    CHECK(refused("sum(1..2, x)") == "sum([1]..2, x): the index of the sum is wanted here");
    CHECK(refused("sum(i=1..2, sum(i=1..2, x[i]))") ==
          "sum(i=1..2, sum([i]=1..2, x[i])): `i` is the index of a sum around this one");
    CHECK(refused("sum(i=1..2, x[i]") == "sum[(]i=1..2, x[i]: this `(` is never closed");
    CHECK(refused("x]") == "x[]]: `]` cannot stand here");
    CHECK(refused("x=2") == "x[=]2: `=` cannot stand here");
    CHECK(refused("sum(i=1..99999, sum(j=1..99999, x))") ==
          "sum(i=1..99999, sum(j=1..99999, [x])): the sums expand to more than 100000 words");
    CHECK(refused("x[99999999999]") == "x[[99999999999]]: a whole number is wanted here");
    CHECK(refused("x[1]2") == "x[1][2]: an operator is missing before this");
}

TEST_CASE("a name has one index, and what helps is said where there are two") {
    const auto refused = [](const std::string& text) {
        return refusal([&] { return parse_indexed_expression(source(text)); });
    };
    const auto names_refused = [](const std::string& text) {
        return refusal([&] { return parse_names(source(text)); });
    };
    for (const Refusal& error : {refused("K[i][j]"), refused("K[1][2]"),
                                 refused("sum(i=1..2, K[i][i])"), names_refused("K[1..3][1..3]")}) {
        INFO(error.marked);
        CHECK(error.what == "a name has one index");
        CHECK(error.marked.find("][[]") != std::string::npos);
        CHECK(error.helps("`K[3*(i-1)+j]`"));
    }
    for (const Refusal& error :
         {refused("K[i,j]"), refused("K[1,2]"), names_refused("K[1..3,1]")}) {
        INFO(error.marked);
        CHECK(error.what == "a name has one index");
        CHECK(error.marked.find("[,]") != std::string::npos);
        CHECK(error.helps("`K[3*(i-1)+j]`"));
    }
    CHECK(refused("sum(i=1:3, x[i])").helps("`1..3`"));
}

TEST_CASE("without indices none are read") {
    const auto refused = [](const std::string& text) {
        const Refusal error = refusal([&] { return parse_expression(source(text)); });
        return error.marked + ": " + error.what;
    };
    CHECK(refused("x[1]") == "x[[]1]: the character `[` cannot stand here");
    const Refusal index = refusal([] { return parse_expression(source("x[1]")); });
    CHECK_FALSE(index.helps("parentheses"));
    CHECK(refused("1..2") == "1.[.2]: a number follows a number");
    CHECK(refused("sum(i, 2)") == "[sum](i, 2): there is no function `sum`");
}
