// SPDX-License-Identifier: GPL-2.0-or-later
#include <string>

#include <catch2/catch.hpp>

#include "generator/exact/numbers/rational_value.hpp"

using namespace hvi::gen;

TEST_CASE("a rational is in lowest terms, with its sign above") {
    const Rational value = Rational::read("6/-4");
    CHECK(value.text() == "-3/2");
    CHECK(value.numerator() == -3);
    CHECK(value.denominator() == 2);
    CHECK(value == Rational(-3) / 2);
    CHECK(Rational::read("7").text() == "7");
    CHECK(Rational().denominator() == 1);
}

TEST_CASE("rationals beyond a machine word stay exact") {
    const Rational large = power(Rational(10), 40);
    CHECK(large.text() == "1" + std::string(40, '0'));
    CHECK(large * power(Rational(10), -40) == 1);
    CHECK((large.numerator() * large.numerator()).text() == "1" + std::string(80, '0'));
    CHECK(abs(-large) == large);
    CHECK(-large < 0);
}

TEST_CASE("the common divisor of rationals leaves coprime integers") {
    const Rational divisor = gcd(Rational(3) / 2, Rational(-9) / 4);
    CHECK(divisor == Rational(3) / 4);
    CHECK(gcd(Rational(), Rational(-5)) == 5);
}

TEST_CASE("remainders are not negative, and multiples have no sign") {
    CHECK(mod(Integer(-1), 14) == 13);
    CHECK(mod(Integer(28), 14) == 0);
    CHECK(lcm(Integer(4), -6) == 12);
    CHECK(Integer(-9).is_multiple_of(3));
    CHECK_FALSE(Integer(-8).is_multiple_of(3));
}
