// A closed form can be read back, and gives the number that it came from.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "generator/read/names.hpp"
#include "tests/generator/exact/exact.hpp"

using namespace hvi::gen;

namespace {

/// Whether the text of a number, read in the number's own field, is the number.
bool reads_back(const std::string& given) {
    return on_new_ground([&](const Ground& ground) {
        const Number number = read(given, ground);
        return (number - read(text(number), ground)).is_zero();
    });
}

/// Whether a divisor has `name` in it.
bool divides_by(const Expression& expression, const std::string& name) {
    bool found = false;
    walk(expression, [&](const Expression& part) {
        if (part.kind != Expression::Kind::reciprocal) return true;
        walk(part, [&](const Expression& inner) {
            found = found || inner.name == name;
            return true;
        });
        return true;
    });
    return found;
}

}  // namespace

TEST_CASE("the text of a number is read back as the number") {
    const auto given = GENERATE(
        as<std::string>(),  //
        "0", "-7/3", "10^40/3",
        // square roots
        "sqrt(2)", "-sqrt(2)/3", "sqrt(2)+sqrt(3)+sqrt(6)", "1/(sqrt(2)+sqrt(3)+sqrt(5)+sqrt(7))",
        "sqrt(2+sqrt(2+sqrt(2)))", "sqrt(2+sqrt(3))*sqrt(5-sqrt(7))",
        "sqrt(525-70*sqrt(30))+sqrt(525+70*sqrt(30))", "sqrt(525-70*sqrt(30))*sqrt(30)/7",
        // angles
        "cos(pi/24)", "sin(pi/16)", "cos(pi/15)", "cos(pi/9)", "sin(pi/18)", "sin(2*pi/5)*sqrt(pi)",
        // transcendental numbers
        "pi", "1/2-1/pi", "(pi^2-2*pi-4)/(2*pi^2-4*pi)", "sqrt(2)/(pi-sqrt(3))", "1/sqrt(pi)",
        "sqrt(1+pi)", "e", "exp(-2)", "exp(sqrt(3)/6)/(1-exp(sqrt(3)/3))", "(e-2)/(e-1)",
        "exp(7/3)-1", "cos(1)", "sin(2)/cos(1)^3", "sin(1/3)", "cos(sqrt(2))*exp(pi)", "log(2)",
        "log(12/5)", "tanh(1/4)", "tan(1)",
        // free parameters
        "w", "1/w", "(w-1)/(w+v)", "sin(w/3)^3/w", "exp(-w)/(1+exp(2*w))",
        "(w*cos(w/3)-4*sin(2*w/3))/(4*w*sin(w/3)^2)", "-v*w");
    CAPTURE(given, normal(given));
    CHECK(reads_back(given));
}

TEST_CASE("every entry of a tableau is read back as itself") {
    const auto given = GENERATE(
        as<std::string>(), "symplectic-euler", "stormer-verlet", "trig3", "chebyshev:3",
        "chebyshev:4", "gauss:2", "gauss:3", "gauss:4", "gauss:5", "lobatto:4", "radau-left:3",
        "radau-right:2", "clenshaw-curtis:5", "fejer:4", "1, cos(pi*tau) | gauss:2",
        "1, exp(tau) | gauss:2", "1, exp(tau), exp(-tau) | 0, 1/2, 1",
        "1, cos(2*pi*tau), sin(2*pi*tau) | 0, 1/3, 2/3",
        "1, tau, cos(tau), sin(tau) | 0, 1/3, 2/3, 1", "1, tau*exp(-2*tau) | 1/4, 3/4");
    CAPTURE(given);
    const NumberVector entries = all_entries(derive(any_method(given)));
    on_new_ground([&](const Ground& ground) {
        for (const Number& entry : entries) {
            CAPTURE(text(entry));
            const Number number = read(text(entry), ground);
            CHECK(number.decimal(60) == entry.decimal(60));
            CHECK((number - read(text(number), ground)).is_zero());
        }
        return true;
    });
}

TEST_CASE("entries with a free parameter are read back") {
    const Tableau tableau = derive(method("1, tau, cos(w*tau), sin(w*tau)", "0, 1/3, 2/3, 1"));
    CHECK(tableau.parameters == std::vector<std::string>{"w"});
    const NumberVector entries = all_entries(tableau);
    CHECK(on_new_ground([&](const Ground& ground) {
        for (const Number& entry : entries) {
            const Number number = read(text(entry), ground);
            if (!(number - read(text(number), ground)).is_zero()) return false;
        }
        return true;
    }));
}

TEST_CASE("an algebraic number has a rational denominator") {
    for (const char* given :
         {"1/sqrt(2)", "1/(1+sqrt(2)+sqrt(3))", "1/sqrt(2+sqrt(2))", "sqrt(1/(5-sqrt(5)))",
          "1/cos(pi/24)", "1/(sqrt(525-70*sqrt(30))+1)"}) {
        CAPTURE(given, normal(given));
        CHECK_FALSE(divides_by(*number(given).closed_form(), "sqrt"));
    }
    for (const Number& entry : all_entries(derive(method("gauss:4")))) {
        CAPTURE(text(entry));
        CHECK_FALSE(divides_by(*entry.closed_form(), "sqrt"));
    }
}

TEST_CASE("rational functions of h are written out as in Section 6") {
    const auto expanded = [](const std::string& given) {
        return to_text(*number(given).expanded_form("h"));
    };
    // (6.2)
    CHECK(expanded("(1+h/2+5*h^2/48+h^3/96)/(1-h/2+5*h^2/48-h^3/96)") ==
          "-(h^3+10*h^2+48*h+96)/(h^3-10*h^2+48*h-96)");
    CHECK(expanded("(1-h/2+5*h^2/48-h^3/96)/(1+h/2+5*h^2/48+h^3/96)") ==
          "(-h^3+10*h^2-48*h+96)/(h^3+10*h^2+48*h+96)");
    // (6.3)
    CHECK(expanded("(1+h/2+h^2/12)/(1-h/2+h^2/12)") == "(h^2+6*h+12)/(h^2-6*h+12)");
    // (6.5), (6.6)
    CHECK(
        expanded("(9216-w^6*h^6+228*h^4*w^4-4320*(h*w)^2)/(h^6*w^6-12*h^4*w^4+288*h^2*w^2+9216)") ==
        "(-h^6*w^6+228*h^4*w^4-4320*h^2*w^2+9216)/(h^6*w^6-12*h^4*w^4+288*h^2*w^2+9216)");
    CHECK(expanded("12*h*(12-h^2*w^2)/(h^4*w^4+12*h^2*w^2+144)") ==
          "(-12*h^3*w^2+144*h)/(h^4*w^4+12*h^2*w^2+144)");
    // other letters, which stand before h in the alphabet
    CHECK(expanded("(a^3+a*h^2-b^5*h)/(a+h)") == "(a*h^2-b^5*h+a^3)/(h+a)");
    CHECK(expanded("1/(a+b)") == "1/(a+b)");
    CHECK(expanded("1/(a-h)") == "-1/(h-a)");
    CHECK(expanded("(b-h)/(a-h)") == "(h-b)/(h-a)");
    CHECK(expanded("(h+pi)/(pi*h^2-1)") == "(h+pi)/(h^2*pi-1)");
    // polynomials
    CHECK(expanded("1-h^2*w^2/2") == "1-h^2*w^2/2");
    CHECK(expanded("h^3*w^4/4-h*w^2") == "-h*w^2+h^3*w^4/4");
    CHECK(expanded("(h+1)/m") == "1/m+h/m");
    CHECK(expanded("0") == "0");
    CHECK(expanded("-3/4") == "-3/4");
    CHECK(expanded("sqrt(2)*h/(1+h)") == "h*sqrt(2)/(h+1)");
    CHECK_FALSE(number("log(pi)").expanded_form("h"));
}

TEST_CASE("what has no closed form says so") {
    CHECK(normal("cos(pi/11)") == "none");
    CHECK(normal("log(pi)") == "none");
    CHECK(derive(method("gauss:6")).c[0].closed_form() == std::nullopt);
}
