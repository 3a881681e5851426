// Exact arithmetic has an end: beyond it numbers are known by their enclosures, or the error says
// what is too large. Expected digits: mpmath, 60 digits.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <memory>

#include <catch2/catch.hpp>

#include "tests/generator/exact/exact.hpp"

using namespace hvi::gen;

TEST_CASE("functions of high multiples of several angles are left to enclosures") {
    // cos(7/9) is a polynomial of degree 7 in cos(1/9), with coefficients up to 112
    const Number sine = number("sin(cos(7/9))");
    CHECK(text(sine) == "none");
    CHECK(sine.decimal(30) == "0.653708434175571171462477782959");
    const Number tangent = number("tan(cos(7/9))");
    CHECK(tangent.decimal(30) == "0.863840696985729046131602155473");
    CHECK(derive(method("sin(cos(7/9))", "1/2")).A[0][0].decimal(20) == "0.50000000000000000000");
}

TEST_CASE("coefficients that would take thousands of terms have digits instead") {
    const Tableau tableau = derive(method("1, tau*exp(-tau/2), sin(-4*tau)", "radau-left:3"));
    CHECK(tableau.b[0].decimal(30) == "0.112956696493304318104824494341");
    CHECK(tableau.b[1].decimal(30) == "0.508488437288773390596371318245");
    CHECK(tableau.b[2].decimal(30) == "0.378554866217922291298804187414");
    CHECK(text(tableau.A_tilde[1][2]) == "none");
    CHECK(text(tableau.A[0][1]) == "0");  // what is exactly 0 stays so
}

TEST_CASE("coefficients of some hundred terms stay exact") {
    const Tableau tableau = derive(method("1, cos(w*tau), sin(w*tau)", "gauss:3"));
    for (const Number& entry : all_entries(tableau)) { CHECK(text(entry) != "none"); }
    const Tableau surds = derive(method("1, tau, tau^2", "1/sqrt(7), 1/sqrt(5), 1/sqrt(3)"));
    for (const Number& entry : all_entries(surds)) { CHECK(text(entry) != "none"); }
}

TEST_CASE("with free parameters too long numbers are refused") {
    const Method given = method("1, cos(w*tau), sin(v*tau)", "gauss:3");
    const Refusal refused = refusal([&] { return derive(given); });
    CHECK(refused.status == 1);
    CHECK(refused.says("gets too large: polynomials of more than 8192 terms"));
    CHECK(refused.name == "--basis");
    CHECK(refused.marked == "[1, cos(w*tau), sin(v*tau)]");
    CHECK(refused.helps("--param"));
}

TEST_CASE("a number that nothing tells from zero is zero to so many places") {
    // (3^(1/3))^3 = 3, which the enclosures of exp cannot prove
    const Ground ground(std::make_shared<Field>(Denominators{}));
    const Number root = ground.exp(ground.log(Number(3)) / Number(3));
    const Number zero = root * root * root - Number(3);
    CHECK(text(zero) == "none");
    CHECK(zero.decimal(20) == "0e-20");
    CHECK(zero.decimal(50) == "0e-50");
    CHECK(zero.nearest_double() == 0.0);
    CHECK_FALSE(std::signbit(zero.nearest_double()));
    CHECK(zero.known_zero() == std::nullopt);
    // what is tiny and is told from zero has its digits
    CHECK((root * ground.exp(Number(-1000))).decimal(5) == "7.3208e-435");
}

TEST_CASE("zeros of an inverse are exact where exact entries give them") {
    // M = [[1, 1, 1], [0, 3^(-2/3), 1], [1, 0, 0]]
    const Tableau tableau = derive(method("1, tau^(2/3), cos((3/2)*pi*tau)", "0, 1/3, 1"));
    CHECK(texts(tableau.galerkin->M_inverse[0]) == std::vector<std::string>{"0", "0", "1"});
    const auto refused =
        refusal([] { return derive(method("1, tau^(1/3), (3*tau-1)*(tau-1)", "0, 1/3, 1")); });
    CHECK(refused.status == 1);
    CHECK(refused.says("the weight of node 1, c = 0, is zero"));
}
