// Error messages as users see them.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "generator/support/error.hpp"

using namespace hvi::gen;

namespace {

std::string shown(const std::string& text, Range range) {
    const auto source = std::make_shared<const Source>(Source{"--basis", text});
    return message(InputError("what", Place{source, range}, "help"));
}

}  // namespace

TEST_CASE("an error says what, where, and what would help") {
    CHECK(shown("1, coz(tau)", {3, 6}) == "error: what\n"
                                          "  --basis: 1, coz(tau)\n"
                                          "              ^~~\n"
                                          "help: help\n");
    CHECK(message(InputError("what")) == "error: what\n");
    CHECK(message(EnvironmentError("what", "help")) == "error: what\nhelp: help\n");
}

TEST_CASE("carets at the ends of a text") {
    CHECK(shown("ab", {2, 2}) == "error: what\n  --basis: ab\n             ^\nhelp: help\n");
    CHECK(shown("ab", {0, 2}) == "error: what\n  --basis: ab\n           ^~\nhelp: help\n");
    CHECK(shown("", {0, 0}) == "error: what\n  --basis: \n           ^\nhelp: help\n");
    CHECK(shown("ab", {7, 9}) == "error: what\n  --basis: ab\n             ^\nhelp: help\n");
}

TEST_CASE("letters of other alphabets take one column, all else that is not ASCII becomes one ?") {
    CHECK(shown("\u03c0*tau", {3, 6}) ==
          "error: what\n  --basis: \u03c0*tau\n             ^~~\nhelp: help\n");
    CHECK(shown("\u221a2+x", {5, 6}) ==
          "error: what\n  --basis: ?2+x\n              ^\nhelp: help\n");
    CHECK(shown("\U0001f600+x", {5, 6}) ==
          "error: what\n  --basis: ?+x\n             ^\nhelp: help\n");
    CHECK(shown("\u0301+x", {3, 4}) == "error: what\n  --basis: ?+x\n             ^\nhelp: help\n");
}

TEST_CASE("nothing reaches the terminal that it would act on") {
    const std::string hostile = "\x1b[2J\x07\x08\x7f\xc2\x9b"
                                "31m\xe2\x80\xae\xff\xc3\t\r\nx";
    const std::string text = shown(hostile, {hostile.size() - 1, hostile.size()});
    CHECK(text.find("  --basis: ?[2J????31m???   x\n") != std::string::npos);
    CHECK(message(InputError(hostile, {}, hostile)) ==
          "error: ?[2J????31m???   x\nhelp: ?[2J????31m???   x\n");
}

TEST_CASE("of a long text a window around the caret is shown") {
    const std::string text = std::string(1000, 'a') + "#" + std::string(1000, 'b');
    CHECK(shown(text, {1000, 1001}) == "error: what\n"
                                       "  --basis: ..." +
                                           std::string(32, 'a') + "#" + std::string(31, 'b') +
                                           "...\n" + std::string(11 + 3 + 32, ' ') +
                                           "^\nhelp: help\n");
    CHECK(shown(text, {0, 2001}) == "error: what\n"
                                    "  --basis: " +
                                        std::string(64, 'a') + "...\n" + std::string(11, ' ') +
                                        "^" + std::string(63, '~') + "\nhelp: help\n");
    CHECK(shown(text, {2001, 2001}) == "error: what\n"
                                       "  --basis: ..." +
                                           std::string(64, 'b') + "\n" +
                                           std::string(11 + 3 + 64, ' ') + "^\nhelp: help\n");
}

TEST_CASE("long names and long words are cut") {
    const auto source =
        std::make_shared<const Source>(Source{std::string(500, 'd') + "/file.toml", "x"});
    const std::string text = message(InputError(std::string(5000, 'w'), Place{source, {0, 1}}));
    CHECK(text.size() < 800);
    CHECK(text.find("/file.toml: x\n") != std::string::npos);
}

TEST_CASE("of a long word, and of a long quotation, the ends are shown") {
    const std::string name = std::string(5000, 'a') + std::string(5000, 'b');
    const std::string shown = std::string(60, 'a') + "..." + std::string(20, 'b');
    CHECK(message(InputError("cannot write " + name + " now")) ==
          "error: cannot write " + shown + " now\n");
    const std::string words = [] {
        std::string text;
        for (int i = 0; i < 1000; ++i) { text += "ab "; }
        return text;
    }();
    const std::string quoted = message(InputError("unknown `" + words + "`", {}, "`" + name + "`"));
    CHECK(quoted.size() < 250);
    CHECK(quoted.rfind("error: unknown `ab ab ", 0) == 0);
    CHECK(quoted.find(" ab `\n") != std::string::npos);
    CHECK(quoted.find("b`\n") != std::string::npos);
    const std::string fits(80, 'c');
    CHECK(message(InputError(fits)) == "error: " + fits + "\n");
}

TEST_CASE("a broken invariant is a bug, and says so") {
    const auto broken = [] { HVI_CHECK(1 + 1 == 3); };
    CHECK_THROWS_AS(broken(), InternalError);
    try {
        broken();
    } catch (const Error& error) {
        CHECK(error.status() == ExitStatus::bug);
        CHECK(message(error).find("`1 + 1 == 3`") != std::string::npos);
        CHECK(message(error).find("report") != std::string::npos);
    }
}

TEST_CASE("of several lines of a file the one with the place is shown") {
    const std::string text = "one\n  two\nthree";
    const auto lines = [&](const std::string& name, Range range) {
        const auto source = std::make_shared<const Source>(Source{name, text});
        return message(InputError("what", Place{source, range}));
    };
    CHECK(lines("a.toml:9", {0, 3}) == "error: what\n  a.toml:9: one\n            ^~~\n");
    CHECK(lines("a.toml:9", {6, 9}) == "error: what\n  a.toml:10:   two\n               ^~~\n");
    CHECK(lines("a.toml:9", {6, 13}) == "error: what\n  a.toml:10:   two\n               ^~~\n");
    CHECK(lines("a.toml:9", {10, 15}) == "error: what\n  a.toml:11: three\n             ^~~~~\n");
    CHECK(lines("--basis", {6, 9}) ==
          "error: what\n  --basis: one   two three\n                 ^~~\n");
    CHECK(lines("b:123456789012345678901", {6, 9}).find("one   two") != std::string::npos);
}
