// Grammars, and what headers are looked at for.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <string>
#include <string_view>

#include <catch2/catch.hpp>

#include "tests/generator/fuzz/grammar.hpp"
#include "tests/generator/fuzz/header_text.hpp"

using namespace hvi::gen::fuzz;

TEST_CASE("bytes choose alternatives, and without them it is the first") {
    const Grammar grammar("sum: <term> | <term>+<sum>\n"
                          "term: x | <$name>\n"
                          "    | 1~\n"
                          "$name: _ | a | b\n");
    CHECK(grammar.derive("") == "x");
    CHECK(grammar.derive(std::string_view("\1\2\0\0", 4)) == "1\n+x");
    CHECK(grammar.derive(std::string_view("\1\1\2\1\2\0\1", 7)) == "b+1\n+b");
    CHECK(grammar.derive(std::string_view("\0\4\3", 3)).empty());
    CHECK_THROWS(Grammar("sum: <term>\n"));
}

TEST_CASE("a header that a compiler would refuse is found out") {
    const auto header = [](const std::string& lines) {
        return "#pragma once\nnamespace a {\n" + lines + "}\n";
    };
    CHECK_NOTHROW(check_header(header("template <class = void>\nstruct B {\n    double k = -1e-3;\n"
                                      "    double l =\n        2;  // 1 of 2\n};\n")));
    for (const char* lines :
         {"double k = 1;  //\n    1/2\n", "double k = 1;  // 1\n2/3\n",
          "double k = 1;  //\n    sqrt(3)\n", "double k = 1 2;\n", "// ends in \\\nstruct B {};\n",
          "double f(double x) { return (x; }\n", "struct B {\n", "double M_PI = 1;\n",
          "double class = 1;\n", "double f() { return p.class; }\n"}) {
        INFO(lines);
        CHECK_THROWS(check_header(header(lines)));
    }
    CHECK_THROWS(check_header(""));
}
