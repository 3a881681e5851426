// Numbers with a power of ten in a text.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <string>

#include <catch2/catch.hpp>

#include "generator/support/powers.hpp"

using namespace hvi::gen;

namespace {

/// Each power between brackets, all else in capitals where it is an a.
std::string marked(const std::string& text) {
    return with_powers(
        text,
        [](std::string plain) {
            for (char& c : plain) c = c == 'a' ? 'A' : c;
            return plain;
        },
        [](const PowerOfTen& number) {
            return "[" + number.factor + "|" + std::to_string(number.exponent) + "]";
        });
}

}  // namespace

TEST_CASE("numbers with an exponent are powers of ten") {
    CHECK(marked("6.8e-26") == "[6.8|-26]");
    CHECK(marked("a 1e-04, a") == "A [|-4], A");
    CHECK(marked("h = 1e300") == "h = [|300]");
    CHECK(marked("-2.50e+02.") == "-[2.50|2].");
    CHECK(marked("1e-4 and 2e5") == "[|-4] And [2|5]");
    CHECK(marked("") == "");
}

TEST_CASE("parts of words are no powers") {
    for (const std::string text : {"x1e5", "1e5x", "1e", "2e_3", "scene-2ek", "0x1e5", "1e5.5",
                                   "1.2.3e4", "lobatto:3", "1e12345"})
        CHECK(marked(text).find('[') == std::string::npos);
}
