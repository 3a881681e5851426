// Lines of generated text: where they break, and what may not end them.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <string>

#include <catch2/catch.hpp>

#include "generator/emit/text/text.hpp"

using namespace hvi::gen;

TEST_CASE("a comment behind a statement that does not fit stands above it, never below") {
    const std::string fraction = "10015851063790825241111111/10000000000000000000000000";
    const std::string value = "rounded(1.0015851f, 1.0015851063790826, -0x1.648p-54, 0.0)";
    Writer writer(1);
    writer.line("Scalar m = {};  // m = {}", value, fraction);
    CHECK(writer.str() == "// m = " + fraction + "\nScalar m = " + value + ";");
}

TEST_CASE("a comment stays behind a statement of two lines where it fits there") {
    const std::string long_sum = std::string(60, 'a') + " + " + std::string(60, 'b');
    Writer writer(0);
    writer.line("x = {};  // 1/3", long_sum);
    CHECK(writer.str() ==
          "x = " + std::string(60, 'a') + "\n    + " + std::string(60, 'b') + ";  // 1/3");
}

TEST_CASE("a statement that is too long beside its comment is broken without it") {
    const std::string words = std::string(60, 'a') + " + " + std::string(50, 'b');
    Writer writer(0);
    writer.line("x = {};  // {}", words, std::string(60, '7'));
    CHECK(writer.str() == "// " + std::string(60, '7') + "\nx = " + std::string(60, 'a') +
                              "\n    + " + std::string(50, 'b') + ";");
}

TEST_CASE("no line of a comment goes on in the next") {
    const auto line_of = [](const std::string& text) {
        return Writer(0).comment(text).line("code").str();
    };
    CHECK(line_of("ends \\") == "// ends\ncode");
    CHECK(line_of("ends \\ ") == "// ends\ncode");
    CHECK(line_of("what?\?/") == "// what\ncode");
    CHECK(line_of("both \\ ?\?/ \\") == "// both\ncode");
    CHECK(line_of("a \\ b ?\?/ c?") == "// a \\ b ?\?/ c?\ncode");
    CHECK(line_of("\\") == "// \ncode");
    CHECK(line_of(std::string(95, 'a') + " \\ b") == "// " + std::string(95, 'a') + "\n// b\ncode");
}
