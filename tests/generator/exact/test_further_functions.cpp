// Functions that few methods call: exact values, integrals, and what is refused.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "tests/generator/exact/function.hpp"
#include "tests/generator/exact/refusals.hpp"

using namespace hvi::gen;

namespace {

/// A number to 50 digits.
std::string number_digits(const std::string& given) {
    return on_new_ground([&](const Ground& ground) { return read(given, ground).decimal(50); });
}

Refusal refused_number(const std::string& given) { return refused("1", given); }

}  // namespace

TEST_CASE("numbers that the field has a place for") {
    CHECK(constant("log10(100)") == "2");
    CHECK(constant("log10(1/1000)") == "-3");
    CHECK(constant("cbrt(8)") == "2");
    CHECK(constant("cbrt(-27/8)") == "-3/2");
    CHECK(constant("cbrt(0)") == "0");
    CHECK(constant("asinh(3/4)") == "log(2)");
    CHECK(constant("asinh(-3/4)+log(2)") == "0");
    CHECK(constant("asinh(0)") == "0");
    CHECK(constant("acosh(5/4)") == "log(2)");
    CHECK(constant("acosh(1)") == "0");
    CHECK(constant("atanh(1/2)-log(3)/2") == "0");
    CHECK(constant("erf(0)") == "0");
    CHECK(constant("erfc(0)") == "1");
    CHECK(constant("atan2(1,-1)") == "3*pi/4");
    CHECK(constant("atan2(-sqrt(3),-1)+2*pi/3") == "0");
    CHECK(constant("atan2(-2,0)") == "-pi/2");
    CHECK(constant("atan2(0,-2)") == "pi");
}

TEST_CASE("numbers that are enclosed, against decimals of mpmath") {
    CHECK(number_digits("erf(1)") == "0.84270079294971486934122063508260925929606699796630");
    CHECK(number_digits("erf(3/8)") == "0.40411690943482229832382508591912176753043404675108");
    CHECK(number_digits("erfc(3/8)") == "0.59588309056517770167617491408087823246956595324892");
    CHECK(number_digits("asinh(1)") == "0.88137358701954302523260932497979230902816032826164");
    CHECK(number_digits("acosh(2)") == "1.3169578969248167086250463473079684440269819714675");
    CHECK(number_digits("cbrt(3/8)") == "0.72112478515370419116081915539005479419593462674968");
    CHECK(number_digits("-cbrt(-3/8)") == number_digits("cbrt(3/8)"));
    CHECK(number_digits("cbrt(-erf(1))^3") == "-" + number_digits("erf(1)"));
    CHECK(number_digits("log10(3/8)") == "-0.42596873227228114834618878091836377110444078019563");
    CHECK(number_digits("atan2(3/8,-5/4)") ==
          "2.8501358591119261464670387618466116906940018003630");
}

TEST_CASE("comparisons of numbers are decided") {
    CHECK(constant("abs(1-sqrt(2))-sqrt(2)") == "-1");
    CHECK(constant("sign(sqrt(2)+sqrt(3)-sqrt(5+2*sqrt(6)))") == "0");
    CHECK(constant("sign(22/7-pi)") == "1");
    CHECK(constant("min(pi,22/7)") == "pi");
    CHECK(constant("max(pi,22/7)") == "22/7");
    CHECK(constant("if(sqrt(2)^2<2,1,3)") == "3");
    CHECK(constant("if(sqrt(2)^2<=2,1,3)") == "1");
    CHECK(constant("if(erf(1)<1,1,log(-1))") == "1");  // what is not chosen needs no value
    CHECK(refused_number("sign(erf(1)+erfc(1)-1)").says("cannot decide"));
}

TEST_CASE("integrals of functions by their closed forms") {
    CHECK(integrates("log10(1+tau)", "1", "(2*log(2)-1)/log(10)"));
    CHECK(integrates("atanh(tau/2)", "1", "(3*log(3)-4*log(2))/2"));
    CHECK(integrates("atanh(tau)", "1", "log(2)"));  // infinite at the end
    CHECK(integrates("cbrt(tau)", "1", "3/4"));
    CHECK(integrates("cbrt(-8*tau)", "1", "-3/2"));
    CHECK(integrates("asinh(tau)", "3/4", "3*log(2)/4-1/4"));
    CHECK(integrates("acosh(1+tau)", "1/4", "5*log(2)/4-3/4"));
}

TEST_CASE("integrals of functions to 50 digits") {
    // By closed forms, evaluated with 80 digits: erf(1) + (1/e - 1)/sqrt(pi), ...
    CHECK(integral_digits("erf(tau)", "1") ==
          "0.48606495811225593406327530824250535613646988360694");
    CHECK(integral_digits("erfc(tau)", "1") ==
          "0.51393504188774406593672469175749464386353011639306");
    CHECK(integral_digits("asinh(tau)", "1") ==
          "0.46716002464644797643092060077009423045848845288469");
    CHECK(integral_digits("tau*asinh(tau)", "1") ==
          "0.30747679967138350672403481268241971212870227735199");
    CHECK(integral_digits("acosh(1+tau)", "1") ==
          "0.90186498628075612372264635311006452111115868912465");
}

TEST_CASE("what is not real, and what is not built yet") {
    CHECK(refused_number("acosh(1/2)").says("the arcosh of a number below 1 is not real"));
    CHECK(refused_number("atanh(1)").says("the artanh of a number that is not between -1 and 1"));
    CHECK(refused_number("log10(-1)").says("not positive"));
    CHECK(refused_number("1, atan2(0,0)").marked == "1, [atan2(0,0)]");
    CHECK(refused("1, acosh(tau)", "0, 1").says("x-1 for the argument x of this acosh"));
    CHECK(refused("1, atanh(2*tau)", "0, 1").says("1-x for the argument x of this atanh"));
    CHECK(refused("1, cbrt(tau-1/2)", "0, 1").marked == "1, [cbrt(tau-1/2)]");
    CHECK(refused("1, abs(tau-1/2)", "0, 1").marked == "1, abs([tau-1/2])");
    CHECK(refused("1, min(tau,1/2)", "0, 1").says("the integrals of `min` of a function"));
    CHECK(refused("1, if(tau<1/2,0,1)", "0, 1").says("the integrals of `if` of a function"));
    CHECK(refused("1, atan2(tau,1)", "0, 1").status == input);
    CHECK(refused("1, erf(tau), abs(w)*tau", "0, 1/2, 1").says("free parameter"));
}

TEST_CASE("a free parameter is not compared with a number that has no closed form") {
    for (const char* text : {"if(w<erf(1),1,2)", "min(w,erf(1))", "w-erf(1)", "w*erf(1)",
                             "erf(1)/w", "acos(w*erf(1))", "sqrt(w+erf(1))"}) {
        const Refusal found = refused_number(text);
        INFO(text << ": " << found.what);
        CHECK(found.status == 2);
        CHECK(found.says("free parameter"));
        CHECK(found.helps("--param"));
    }
}
