// Functions of tau: normal form, values and integrals.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "tests/exact/exact.hpp"

using namespace hvi::gen;

namespace {

ExactFunction function(const std::string& text, const Ground& ground) {
    const auto given = source(text);
    return evaluate_function(parse_expression(given), given, ground);
}

/// Whether the integral over [0, end] is what the text says.
bool integrates(const std::string& text, const std::string& end, const std::string& expected) {
    return with_ground([&](const Ground& ground) {
        const Number integral = function(text, ground).integral(read(end, ground), ground);
        return (integral - read(expected, ground)).is_zero();
    });
}

bool has_value(const std::string& text, const std::string& point, const std::string& expected) {
    return with_ground([&](const Ground& ground) {
        const Number value = function(text, ground).at(read(point, ground), ground);
        return (value - read(expected, ground)).is_zero();
    });
}

/// The function as a constant, or `none`.
std::string constant(const std::string& given) {
    return with_ground([&](const Ground& ground) {
        const auto number = function(given, ground).constant();
        return number ? text(*number) : "none";
    });
}

std::size_t terms(const std::string& text) {
    return with_ground([&](const Ground& ground) { return function(text, ground).terms().size(); });
}

}  // namespace

TEST_CASE("integrals of polynomials") {
    CHECK(integrates("1", "1/3", "1/3"));
    CHECK(integrates("tau^3", "1/2", "1/64"));
    CHECK(integrates("(tau-1/2)^2", "1", "1/12"));
    CHECK(integrates("6*tau^2-6*tau+1", "1", "0"));
    CHECK(integrates("v*tau", "w", "v*w^2/2"));
}

TEST_CASE("integrals of exponentials") {
    CHECK(integrates("exp(tau)", "1", "e-1"));
    CHECK(integrates("exp(3*tau+1)", "1/2", "(exp(5/2)-e)/3"));
    CHECK(integrates("tau*exp(-2*tau)", "1", "(1-3*exp(-2))/4"));
    CHECK(integrates("tau^2*exp(tau)", "1", "e-2"));
    CHECK(integrates("tau^3*exp(tau)", "1", "6-2*e"));
    CHECK(integrates("exp(w*tau)", "1", "(exp(w)-1)/w"));
    CHECK(integrates("cosh(tau)^2", "1", "1/2+sinh(2)/4"));
}

TEST_CASE("integrals of waves") {
    CHECK(integrates("cos(pi*tau)", "1/2", "1/pi"));
    CHECK(integrates("sin(pi*tau)", "1", "2/pi"));
    CHECK(integrates("tau*sin(pi*tau)", "1", "1/pi"));
    CHECK(integrates("tau^2*cos(pi*tau)", "1", "-2/pi^2"));
    CHECK(integrates("tau^3*sin(pi*tau)", "1", "1/pi-6/pi^3"));
    CHECK(integrates("cos(tau+1/3)", "1", "sin(4/3)-sin(1/3)"));
    CHECK(integrates("cos(w*tau)", "1/3", "sin(w/3)/w"));
}

TEST_CASE("integrals of products") {
    CHECK(integrates("sin(tau)^2", "1", "1/2-sin(2)/4"));
    CHECK(integrates("cos(tau)^2", "1", "1/2+sin(2)/4"));
    CHECK(integrates("cos(3*tau)*sin(2*tau)", "1", "(1-cos(5))/10-(1-cos(1))/2"));
    CHECK(integrates("sin(3*tau)*sin(2*tau)", "1", "sin(1)/2-sin(5)/10"));
    CHECK(integrates("exp(tau)*sin(pi*tau)", "1", "pi*(1+e)/(1+pi^2)"));
    CHECK(integrates("exp(tau)*cos(pi*tau)", "1", "-(1+e)/(1+pi^2)"));
    CHECK(integrates("tau*exp(tau)*cos(tau)", "1", "e*cos(1)/2"));
}

TEST_CASE("values") {
    CHECK(has_value("tau^2*exp(-tau)*cos(2*tau)", "1/2", "exp(-1/2)*cos(1)/4"));
    CHECK(has_value("cos(pi*tau)+sin(pi*tau)", "1/4", "sqrt(2)"));
    CHECK(has_value("exp(tau)", "sqrt(2)", "exp(sqrt(2))"));
    CHECK(has_value("1+tau+tau^2", "0", "1"));
    CHECK(has_value("sin(-w*tau)", "1/2", "-sin(w/2)"));
    CHECK(has_value("1/exp(2*tau)", "1", "exp(-2)"));
}

TEST_CASE("terms that are multiples of each other are one") {
    CHECK(constant("sin(tau)^2+cos(tau)^2") == "1");
    CHECK(constant("exp(tau)*exp(-tau)") == "1");
    CHECK(constant("cos(0*tau)") == "1");
    CHECK(constant("tau-tau") == "0");
    CHECK(constant("tau") == "none");
    CHECK(constant("1+sin(tau)") == "none");
    CHECK(terms("sin(tau)+sin(-tau)") == 0);
    CHECK(terms("cos(w*tau)-cos(-w*tau)") == 0);
    CHECK(terms("sqrt(2)*tau+sqrt(8)*tau") == 1);
    CHECK(terms("(1+tau)^3*exp(tau)") == 4);
    CHECK(terms("cos(sqrt(6)*tau)-cos(sqrt(2)*sqrt(3)*tau)") == 0);
}
