// Decimals and doubles are correctly rounded, half to even.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "tests/generator/exact/exact.hpp"

using namespace hvi::gen;

namespace {

std::string decimal(const std::string& given, int digits) { return number(given).decimal(digits); }

double nearest(const std::string& given) { return number(given).nearest_double(); }

}  // namespace

TEST_CASE("ties of decimals go to the even digit") {
    CHECK(decimal("0.125", 2) == "0.12");
    CHECK(decimal("0.375", 2) == "0.38");
    CHECK(decimal("-0.125", 2) == "-0.12");
    CHECK(decimal("-0.375", 2) == "-0.38");
    CHECK(decimal("2.5", 1) == "2");
    CHECK(decimal("3.5", 1) == "4");
    CHECK(decimal("0.125+1/10^80", 2) == "0.13");
    CHECK(decimal("0.375-1/10^80", 2) == "0.37");
    CHECK(decimal("sqrt(0.015625)", 2) == "0.12");
}

TEST_CASE("a carry makes one digit more before the point") {
    CHECK(decimal("9.9996", 4) == "10.00");
    CHECK(decimal("9.9994", 4) == "9.999");
    CHECK(decimal("-99.96", 3) == "-100");
    CHECK(decimal("0.099999", 3) == "0.100");
    CHECK(decimal("1-1/10^60", 50) == "1." + std::string(49, '0'));
    CHECK(decimal("1-1/10^45", 50) == "0." + std::string(45, '9') + "00000");
}

TEST_CASE("numbers just below 1") {
    CHECK(decimal("exp(-1/10^45)", 50) == "0." + std::string(45, '9') + "00000");
    CHECK(decimal("cos(1/10^22)", 45) == "0." + std::string(44, '9') + "5");
    CHECK(decimal("10*exp(-1/10^45)", 48) == "9." + std::string(44, '9') + "000");
    CHECK(nearest("exp(-1/10^45)") == 1.0);
}

TEST_CASE("many digits") {
    CHECK(decimal("pi", 101) == "3.14159265358979323846264338327950288419716939937510"
                                "58209749445923078164062862089986280348253421170680");
    CHECK(decimal("e", 51) == "2.71828182845904523536028747135266249775724709369996");
    CHECK(decimal("sqrt(2)", 51) == "1.41421356237309504880168872420969807856967187537695");
    CHECK(decimal("1/3", 50) == "0." + std::string(50, '3'));
    CHECK(decimal("-2/3", 50) == "-0." + std::string(49, '6') + "7");
    CHECK(decimal("cos(1)", 20) == "0.54030230586813971740");
    CHECK(decimal("pi", 1) == "3");
    CHECK(decimal("pi", 1000).size() == 1001);
}

TEST_CASE("where the enclosure has to be refined") {
    CHECK(decimal("exp(pi*sqrt(163))", 20) == "262537412640768744.00");
    CHECK(decimal("exp(pi*sqrt(163))", 31) == "262537412640768743.9999999999993");
    CHECK(decimal("exp(pi*sqrt(163))-262537412640768744", 10) == "-7.499274028e-13");
    CHECK(decimal("sqrt(1+2/10^60)-1-1/10^60", 5) == "-5.0000e-121");
}

TEST_CASE("the form of tiny, huge and whole numbers") {
    CHECK(decimal("0", 50) == "0");
    CHECK(decimal("1", 5) == "1.0000");
    CHECK(decimal("1/10^30", 3) == "1.00e-30");
    CHECK(decimal("-1/(3*10^30)", 3) == "-3.33e-31");
    CHECK(decimal("0.000001", 3) == "0.00000100");
    CHECK(decimal("0.0000001", 3) == "1.00e-7");
    CHECK(decimal("123456789", 4) == "123500000");
    CHECK(decimal("10^25", 3) == "1.00e25");
    CHECK(decimal("10^25", 1) == "1e25");
    CHECK(decimal("10^25", 27) == "10000000000000000000000000.0");
    CHECK(decimal("1/10^1000", 3) == "1.00e-1000");
}

TEST_CASE("doubles that are known exactly") {
    CHECK(nearest("0") == 0.0);
    CHECK(nearest("-3") == -3.0);
    CHECK(nearest("1/3") == 0x1.5555555555555p-2);
    CHECK(nearest("2/3") == 0x1.5555555555555p-1);
    CHECK(nearest("1/10") == 0x1.999999999999ap-4);
    CHECK(nearest("pi") == 0x1.921fb54442d18p+1);
    CHECK(nearest("e") == 0x1.5bf0a8b145769p+1);
    CHECK(nearest("sqrt(2)") == 0x1.6a09e667f3bcdp+0);
    CHECK(nearest("-sqrt(2)") == -0x1.6a09e667f3bcdp+0);
    CHECK(nearest("log(2)") == 0x1.62e42fefa39efp-1);
    CHECK(nearest("9007199254740993") == 9007199254740992.0);
    CHECK(nearest("2^1000*(2^24-1/2^29)") == 0x1.fffffffffffffp+1023);
}

TEST_CASE("values half way between two doubles go to the even one") {
    CHECK(nearest("1+2^(-53)") == 1.0);
    CHECK(nearest("1+3*2^(-53)") == 0x1.0000000000002p+0);
    CHECK(nearest("-1-2^(-53)") == -1.0);
    CHECK(nearest("1+2^(-53)+2^(-400)") == 0x1.0000000000001p+0);
    CHECK(nearest("1+3*2^(-53)-2^(-400)") == 0x1.0000000000001p+0);
    CHECK(nearest("1-2^(-54)") == 1.0);
    CHECK(nearest("sqrt(1+2^(-52)+2^(-106))") == 1.0);  // exactly 1 + 2^-53
    CHECK(nearest("sqrt(1+2^(-52)+2^(-106)+2^(-300))") == 0x1.0000000000001p+0);
}

TEST_CASE("doubles below the normal range") {
    CHECK(nearest("2^(-600)*2^(-474)") == 0x1p-1074);
    CHECK(nearest("3*2^(-600)*2^(-475)") == 0x1p-1073);  // a tie: 1.5 goes to 2
    CHECK(nearest("5*2^(-600)*2^(-475)") == 0x1p-1073);  // 2.5 goes to 2
    CHECK(nearest("sqrt(2)*2^(-600)*2^(-474)") == 0x1p-1074);
    CHECK(nearest("1/10^400") == 0.0);
    CHECK(nearest("sqrt(2)/10^400") == 0.0);
}

TEST_CASE("the nearest multiple of a power of two") {
    const auto multiple = [](const std::string& given, int exponent) {
        return number(given).nearest_multiple(exponent).to_double();
    };
    CHECK(multiple("1/3", -10) == 341.0 / 1024);
    CHECK(multiple("-1/3", -10) == -341.0 / 1024);
    CHECK(multiple("pi", 0) == 3.0);
    CHECK(multiple("pi", -51) == 0x1.921fb54442d18p+1);
    CHECK(multiple("pi", -50) == 0x1.921fb54442d18p+1);
    CHECK(multiple("sqrt(2)", -52) == 0x1.6a09e667f3bcdp+0);
    CHECK(multiple("sqrt(2)", -4) == 23.0 / 16);
    CHECK(multiple("1/2", 0) == 0.0);
    CHECK(multiple("3/2", 0) == 2.0);
    CHECK(multiple("5/2", 0) == 2.0);
    CHECK(multiple("1000", 3) == 1000.0);
    CHECK(multiple("1001", 3) == 1000.0);
    CHECK(multiple("1/10^30", -53) == 0.0);
    CHECK(multiple("0", -53) == 0.0);
}

TEST_CASE("the nearest number of so many bits") {
    const auto nearest_of = [](const std::string& given, int bits) {
        return number(given).nearest_of(bits);
    };
    CHECK(nearest_of("1/3", 53).to_double() == 1.0 / 3);
    CHECK(nearest_of("-1/3", 24).to_double() == -0x1.555556p-2);
    CHECK(nearest_of("pi", 53).to_double() == 0x1.921fb54442d18p+1);
    CHECK(nearest_of("0", 24).is_zero());
    // Half to even, and up over a power of two.
    CHECK(nearest_of("9", 3) == Dyadic(8, 0));
    CHECK(nearest_of("11", 3) == Dyadic(12, 0));
    CHECK(nearest_of("15.5", 4) == Dyadic(1, 4));
    CHECK(nearest_of("1-1/10^50", 113) == Dyadic(1, 0));
    // No format bounds the exponent.
    CHECK(nearest_of("2^(-1000)*2^(-1000)/3", 1) == Dyadic(1, -2002));
    // pi in binary128, as its hexadecimal digits have it: 3.243f6a8885a308d313198a2e0370|7344.
    const WideInteger digits = (WideInteger(0x3243f6a8885a30) << 60) + 0x8d313198a2e0370;
    CHECK(nearest_of("pi", 114) == Dyadic(digits, -112));
    CHECK(nearest_of("pi", 113) == Dyadic(digits, -112));
}

TEST_CASE("differences and leading parts of binary numbers") {
    const Dyadic a(5, -3);  // 0.625
    CHECK(a.to_double() == 0.625);
    CHECK(Dyadic(20, -5) == a);
    CHECK((Dyadic(1, 0) - a).to_double() == 0.375);
    CHECK((a - a).is_zero());
    CHECK((a - Dyadic()) == a);
    CHECK((Dyadic() - a).to_double() == -0.625);
    CHECK((a.leading() == -1 && a.last() == -3 && a.bits() == 3));
    CHECK(Dyadic(-0x1ff, 0).cut(8).to_double() == -0x1fe);
    CHECK_THROWS_AS(Dyadic(1, 200) - a, InternalError);
    CHECK_THROWS_AS(Dyadic(0x20000000000001, 0).to_double(), InternalError);
}
