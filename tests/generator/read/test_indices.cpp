// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "generator/read/unroll.hpp"
#include "tests/generator/read/refusal.hpp"

using namespace hvi::gen;

namespace {

Expression read_unrolled(const std::string& text, const WholeNumbers& known = {}) {
    return unrolled(parse_indexed_expression(source(text)), known);
}

std::string expanded(const std::string& text, const WholeNumbers& known = {}) {
    return to_text(read_unrolled(text, known));
}

NameList read_names(const std::string& text, const WholeNumbers& known = {}) {
    return unrolled(name_texts(source(text)), known);
}

std::vector<std::string> names(const std::string& text, const WholeNumbers& known = {}) {
    std::vector<std::string> result;
    for (const DeclaredName& name : read_names(text, known).names) { result.push_back(name.name); }
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

TEST_CASE("sums run over several indices, over none, and to where a parameter says") {
    CHECK(expanded("sum(i=1..2, j=i+1..3, m[i]*m[j])") == "m[1]*m[2]+m[1]*m[3]+m[2]*m[3]");
    CHECK(expanded("sum(i=1..3, j=i+1..3, x[i,j])") == "x[1,2]+x[1,3]+x[2,3]");
    CHECK(expanded("1 + sum(i=1..N, x[i])", {{"N", 2}}) == "1+x[1]+x[2]");
    CHECK(expanded("1 + sum(i=1..N, x[i])", {{"N", 0}}) == "1");
    CHECK(expanded("2*sum(i=1..N, x[i])", {{"N", 0}}) == "2*0");
    CHECK(expanded("sum(i=1..2, 0) + 0") == "0+0+0");
    CHECK(expanded("sum(i=1..N-1, (x[i+1]-x[i])^2)/N", {{"N", 3}}) ==
          "((x[2]-x[1])^2+(x[3]-x[2])^2)/3");
    CHECK(expanded("sum(i=0..N-1, x[mod(i-1,N)]*x[mod(i+1, N)])", {{"N", 3}}) ==
          "x[2]*x[1]+x[0]*x[2]+x[1]*x[0]");
    CHECK(expanded("sum(N=1..2, x[N]) + N", {{"N", 5}}) == "x[1]+x[2]+5");
}

TEST_CASE("the text of an expression with indices is read as it was") {
    for (const std::string text : {"sum(i=1..N,j=i+1..N,m[i]*m[j])", "x[i+1]^2",
                                   "-u[mod(i,N),2*j-1]/3", "sum(i=1..3,x[i])*2"}) {
        const std::string once = to_text(parse_indexed_expression(source(text)).written);
        CHECK(to_text(parse_indexed_expression(source(once)).written) == once);
    }
    CHECK(to_text(parse_indexed_expression(source("sum(i=1..N, u[mod(i+1,N),2])/2")).written) ==
          "sum(i=1..N,u[mod(i+1,N),2])/2");
}

TEST_CASE("names with a range of indices are all of them") {
    CHECK(names("q") == Names{"q"});
    CHECK(names("x[1..3], y") == Names{"x[1]", "x[2]", "x[3]", "y"});
    CHECK(names(" x[0..0] ") == Names{"x[0]"});
    CHECK(names("x[7], x[-1], y") == Names{"x[7]", "x[-1]", "y"});
    CHECK(names("x[1..1000]").size() == 1000);
    CHECK(names("u[0..1,1..2]") == Names{"u[0,1]", "u[0,2]", "u[1,1]", "u[1,2]"});
    CHECK(names("u[1..N,7], v[N]", {{"N", 2}}) == Names{"u[1,7]", "u[2,7]", "v[2]"});
}

TEST_CASE("what is wrong with indices is said where it is") {
    const auto refused = [](const std::string& text) {
        const Refusal error = refusal([&] { return read_unrolled(text); });
        return error.marked + ": " + error.what;
    };
    CHECK(refused("x[1/2]") == "x[[1/2]]: a whole number is wanted here");
    CHECK(refused("x[i]") == "x[[i]]: a whole number is wanted here");
    CHECK(refused("x[1") == "x[1[]: `]` is wanted here");
    CHECK(refused("sum(i=1..2 x[i])") == "sum(i=1..2 [x][i]): an operator is missing before this");
    CHECK(refused("sum(i=1..2)") ==
          "sum(i=1..2[)]: a comma and the term of the sum are wanted here");
    CHECK(refused("sum(i=3..1, x[i])") == "sum(i=[3..1], x[i]): this sum has no term");
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

TEST_CASE("indices stand in one pair of brackets, and what helps is said where there are two") {
    const auto refused = [](const std::string& text) {
        return refusal([&] { return read_unrolled(text); });
    };
    const auto names_refused = [](const std::string& text) {
        return refusal([&] { return read_names(text); });
    };
    for (const Refusal& error : {refused("K[i][j]"), refused("K[1][2]"),
                                 refused("sum(i=1..2, K[i][i])"), names_refused("K[1..3][1..3]")}) {
        INFO(error.marked);
        CHECK(error.what == "indices stand in one pair of brackets");
        CHECK(error.marked.find("][[]") != std::string::npos);
        CHECK(error.helps("`K[i,j]`"));
    }
    CHECK(refused("sum(i=1:3, x[i])").helps("`1..3`"));
}

TEST_CASE("what is wrong with ranges is said where it is") {
    const auto refused = [](const std::string& text, const WholeNumbers& known = {}) {
        const Refusal error = refusal([&] { return read_unrolled(text, known); });
        return error.marked + ": " + error.what;
    };
    CHECK(refused("mod(3,2)") == "[mod](3,2): `mod` stands in indices alone");
    CHECK(refused("x[mod(3)]") == "x[mod(3[)]]: `mod` takes two arguments: as in `mod(i+1, N)`");
    CHECK(refused("x[mod(3,0)]") == "x[[mod(3,0)]]: a whole number is wanted here");
    CHECK(refused("x[mod(3,2,1)]") ==
          "x[mod(3,2[,]1)]: `)` is wanted here: `mod` takes two arguments");
    CHECK(refused("sum(i=1..N, x[i])") == "sum(i=1..[N], x[i]): a whole number is wanted here");
    CHECK(refused("sum(i=1..N*N, x[i])", {{"N", 10001}}) ==
          "sum(i=1..[N*N], x[i]): a whole number is wanted here");
    const auto names_refused = [](const std::string& text) {
        const Refusal error = refusal([&] { return read_names(text); });
        return error.marked + ": " + error.what;
    };
    CHECK(names_refused("x[3..1]") == "x[[3..1]]: there is no such index: from 3 to 1");
    CHECK(names_refused("y, u[1..100,1..100]") ==
          "y, [u[1..100,1..100]]: there are more than 1000 names");
    CHECK(names_refused("x[1;2]").find("`..` is wanted here") == std::string::npos);
    std::string many = "x";
    for (int k = 17; k > 0; --k) { many = "sum(i" + std::to_string(k) + "=1..1, " + many + ")"; }
    CHECK(refused(many).find("there are more than 16 indices here") != std::string::npos);
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
