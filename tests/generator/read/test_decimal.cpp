// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "generator/read/decimal.hpp"
#include "tests/generator/read/refusal.hpp"

using namespace hvi::gen;

namespace {

Expression decimal(const std::string& text) {
    return read_decimal({source(text), {0, text.size()}});
}

}  // namespace

TEST_CASE("a decimal means exactly what is written, in lowest terms") {
    CHECK(decimal("0.1") == Expression::rational("1", "10"));
    CHECK(decimal("0.5") == Expression::rational("1", "2"));
    CHECK(decimal(".25") == Expression::rational("1", "4"));
    CHECK(decimal("1.") == Expression::rational("1", "1"));
    CHECK(decimal("1e-3") == Expression::rational("1", "1000"));
    CHECK(decimal("2.5E-3") == Expression::rational("1", "400"));
    CHECK(decimal("12.5e+3") == Expression::rational("12500", "1"));
    CHECK(decimal("1.20e1") == Expression::rational("12", "1"));
    CHECK(decimal("007") == Expression::rational("7", "1"));
    CHECK(decimal("0.0000") == Expression::rational("0", "1"));
    CHECK(decimal("0e5") == Expression::rational("0", "1"));
    CHECK(decimal("3.14159265358979323846264338327950288") ==
          Expression::rational("19634954084936207740391521145496893",
                               "6250000000000000000000000000000000"));
    CHECK_FALSE(decimal("0.1") == decimal("0.10000000000000001"));
}

TEST_CASE("numbers that only cost time are refused") {
    CHECK(decimal("1e1000").numerator.size() == 1001);
    CHECK(decimal("1e-1000").denominator.size() == 1001);
    CHECK(decimal(std::string(1000, '7')).numerator.size() == 1000);
    CHECK(refusal([] { return decimal("1e1001"); }).marked == "[1e1001]");
    CHECK(refusal([] { return decimal("1e-99999999999999999999"); }).says("exponent"));
    CHECK(refusal([] { return decimal(std::string(1002, '7')); }).says("1000 digits"));
}
