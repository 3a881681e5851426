// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "generator/render/layout.hpp"

using namespace hvi::gen;

TEST_CASE("columns are aligned, and make room for a minus") {
    const Table table{"c", "A", {"0", "1/2"}, {{"-1", "2"}, {"10", "3"}}, "b", {"1", "-4"}};
    CHECK(table_lines(table) == Lines{" c   | A", " 0   | -1    2", " 1/2 |  10   3",
                                      "-----+--------", " b   |  1   -4"});
}

TEST_CASE("blocks side by side") {
    CHECK(beside({"ab", "c"}, {"x"}) == Lines{"ab     x", "c"});
    CHECK(beside({"a"}, {"x", "y"}) == Lines{"a     x", "      y"});
    CHECK(width({"a", "abc", ""}) == 3);
}

TEST_CASE("long lines are broken before a sign outside of parentheses") {
    const std::string term = "sqrt(350-20*sqrt(70))/6480";
    const Lines lines = wrapped(" A = ", term + "+" + term + "-" + term + "+" + term);
    CHECK(lines == Lines{" A = " + term + "+" + term, "     -" + term + "+" + term});
}

TEST_CASE("a line without a good place is broken at an operator, or not at all") {
    const std::string word(50, 'x');
    CHECK(wrapped("b ", word + "*" + word) == Lines{"b " + word, "  *" + word});
    CHECK(wrapped("b ", word + ", " + word) == Lines{"b " + word + ",", "  " + word});
    CHECK(wrapped("", word + word) == Lines{word + word});
    CHECK(wrapped("", word + word + "+y") == Lines{word + word, "+y"});
    CHECK(wrapped("a ", "") == Lines{"a"});
}

TEST_CASE("a unary sign stays with what it belongs to") {
    const std::string word(74, 'x');
    CHECK(wrapped("", word + "*y^-zzzz") == Lines{word, "*y^-zzzz"});
}
