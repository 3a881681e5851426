// Functions of tau: normal form, values and integrals.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "tests/generator/exact/function.hpp"

using namespace hvi::gen;

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

TEST_CASE("integrals of rational functions") {
    CHECK(integrates("1/(1+tau)", "1", "log(2)"));
    CHECK(integrates("1/(1+tau)", "1/2", "log(3/2)"));
    CHECK(integrates("1/(1+tau)^2", "1", "1/2"));
    CHECK(integrates("(1+tau)^(-3)", "1", "3/8"));
    CHECK(integrates("1/(2-3*tau/2)", "1", "2*log(4)/3"));
    CHECK(integrates("tau/(1+tau)", "1", "1-log(2)"));
    CHECK(integrates("(tau^3-1)/(1+tau)", "1", "5/6-2*log(2)"));
    CHECK(integrates("1/((1+tau)*(2+tau))", "1", "log(4/3)"));
    CHECK(integrates("1/(1+tau)-1/(2+tau)", "1", "log(4/3)"));
    CHECK(integrates("1/(1+tau)^2/(2+tau)", "1", "1/2-log(4/3)"));
    CHECK(integrates("1/(1+1/(1+tau))", "1", "1-log(3/2)"));
    CHECK(integrates("1/(1+tau^2)", "1", "pi/4"));
    CHECK(integrates("1/(1+tau^2)", "sqrt(3)", "pi/3"));
    CHECK(integrates("1/(1+tau^2)", "sqrt(3)/3", "pi/6"));
    CHECK(integrates("1/(1+tau^2)", "2-sqrt(3)", "pi/12"));
    CHECK(integrates("1/(1+tau^2)", "sqrt(2)-1", "pi/8"));
    CHECK(integrates("1/(1+tau^2)", "-1", "-pi/4"));
    CHECK(integrates("1/(3+tau^2)", "1", "sqrt(3)*pi/18"));
    CHECK(integrates("1/(1+tau+tau^2)", "1", "sqrt(3)*pi/9"));
    CHECK(integrates("1/(1-tau+tau^2)", "1", "2*sqrt(3)*pi/9"));
    CHECK(integrates("1/(1-2*tau+2*tau^2)", "1", "pi/2"));
    CHECK(integrates("tau/(1+tau^2)", "1", "log(2)/2"));
    CHECK(integrates("tau^2/(1+tau^2)", "1", "1-pi/4"));
    CHECK(integrates("1/(1+tau^2)^2", "1", "1/4+pi/8"));
    CHECK(integrates("tau/(1+tau^2)^2", "1", "1/4"));
    CHECK(integrates("1/(1+tau^2)^3", "1", "1/4+3*pi/32"));
    CHECK(integrates("1/((1+tau)*(1+tau^2))", "1", "log(2)/4+pi/8"));
    CHECK(integrates("1/(tau^2-4)", "1", "-log(3)/4"));
    CHECK(integrates("1/(sqrt(2)+tau)^2", "sqrt(2)", "sqrt(2)/4"));
}

TEST_CASE("integrals of roots") {
    CHECK(integrates("sqrt(1+tau)", "1", "2*(2*sqrt(2)-1)/3"));
    CHECK(integrates("1/sqrt(1+tau)", "1", "2*(sqrt(2)-1)"));
    CHECK(integrates("tau*sqrt(1+tau)", "1", "4*(sqrt(2)+1)/15"));
    CHECK(integrates("tau/sqrt(1+tau)", "1", "(4-2*sqrt(2))/3"));
    CHECK(integrates("(1+tau)^(3/2)", "1", "2*(4*sqrt(2)-1)/5"));
    CHECK(integrates("(1+tau)^(-3/2)", "1", "2-sqrt(2)"));
    CHECK(integrates("sqrt(4-3*tau)", "1", "14/9"));
    CHECK(integrates("sqrt(tau)", "1/2", "sqrt(2)/6"));
    CHECK(integrates("1/sqrt(tau)", "1/4", "1"));
    CHECK(integrates("tau^(1/3)", "1", "3/4"));
    CHECK(integrates("tau^(1/3)", "1/8", "3/64"));
    CHECK(integrates("tau^(2/3)*tau^(1/4)", "1", "12/23"));
    CHECK(integrates("(1-tau)^(-2/3)", "1", "3"));
    CHECK(integrates("sqrt(1-tau^2)", "1", "pi/4"));
    CHECK(integrates("1/sqrt(1-tau^2)", "1/2", "pi/6"));
    CHECK(integrates("tau*sqrt(1-tau^2)", "1", "1/3"));
    CHECK(integrates("tau^2*sqrt(1-tau^2)", "1", "pi/16"));
    CHECK(integrates("(1-tau^2)^(3/2)", "1", "3*pi/16"));
    CHECK(integrates("sqrt(tau-tau^2)", "1", "pi/8"));
    CHECK(integrates("tau/sqrt(1+tau^2)", "1", "sqrt(2)-1"));
}

TEST_CASE("integrals of logarithms and arcs") {
    CHECK(integrates("log(1+tau)", "1", "2*log(2)-1"));
    CHECK(integrates("tau*log(1+tau)", "1", "1/4"));
    CHECK(integrates("log(1+tau)^2", "1", "2*log(2)^2-4*log(2)+2"));
    CHECK(integrates("log(1+tau)/(1+tau)", "1", "log(2)^2/2"));
    CHECK(integrates("log(3-tau)", "1", "3*log(3)-2*log(2)-1"));
    CHECK(integrates("log(tau)", "1", "-1"));
    CHECK(integrates("tau^2*log(tau)", "1", "-1/9"));
    CHECK(integrates("sqrt(tau)*log(tau)", "1", "-4/9"));
    CHECK(integrates("log(1+tau^2)", "1", "log(2)-2+pi/2"));
    CHECK(integrates("tau*log(1+tau^2)", "1", "log(2)-1/2"));
    CHECK(integrates("atan(tau)", "1", "pi/4-log(2)/2"));
    CHECK(integrates("asin(tau)", "1", "pi/2-1"));
    CHECK(integrates("acos(tau)", "1", "1"));
    CHECK(integrates("acos(2*tau-1)", "1", "pi/2"));
    CHECK(integrates("tan(pi*tau/4)", "1", "2*log(2)/pi"));
}

TEST_CASE("values of functions with further factors are exact where the field has them") {
    CHECK(has_value("exp(tau^2)", "1/2", "exp(1/4)"));
    CHECK(has_value("exp(tau^2)", "0", "1"));
    CHECK(has_value("tanh(tau)", "1", "(e^2-1)/(e^2+1)"));
    CHECK(has_value("cos(exp(tau))", "0", "cos(1)"));
    CHECK(has_value("1/(1+tau+tau^3)", "1/2", "8/13"));
    CHECK(has_value("sqrt(1+tau^2)", "1", "sqrt(2)"));
    CHECK(has_value("tau^(1/3)", "8/27", "2/3"));
    CHECK(has_value("tau^(-1/3)", "8/27", "3/2"));
    CHECK(has_value("atan(tau)", "sqrt(3)", "pi/3"));
    CHECK(has_value("asin(tau)", "1/2", "pi/6"));
    CHECK(has_value("acos(tau)", "-1/2", "2*pi/3"));
    CHECK(has_value("exp(tau^2)*exp(tau)/(1+tau)", "1", "e^2/2"));
    CHECK(has_value("log(1+tau)", "-1/2", "-log(2)"));
}

TEST_CASE("what is equal is recognized") {
    CHECK(constant("(1+tau)/(1+tau)") == "1");
    CHECK(constant("(1+tau)*(1+tau^2)/(1+tau+tau^2+tau^3)") == "1");
    CHECK(constant("1/(1+tau)+tau/(1+tau)") == "1");
    CHECK(constant("1/(1/(1+tau)+1/(2+tau))*(2*tau+3)/(tau^2+3*tau+2)") == "1");
    CHECK(constant("sqrt(1+tau)*sqrt(1+tau)-tau") == "1");
    CHECK(constant("sqrt(1+tau)/sqrt(4+4*tau)") == "1/2");
    CHECK(constant("(8-8*tau)^(1/3)/(1-tau)^(1/3)") == "2");
    CHECK(constant("log(2+2*tau)-log(1+tau)") == "log(2)");
    CHECK(constant("log((1+tau)^2*(2+tau))-2*log(1+tau)-log(2+tau)") == "0");
    CHECK(constant("exp(tau^2)*exp(-tau^2)") == "1");
    CHECK(constant("exp(tau+tau^2)/exp(tau)/exp(tau*tau)") == "1");
    CHECK(constant("log(exp(tau^2))-tau^2") == "0");
    CHECK(constant("exp(2*log(1+tau))/(1+tau)^2") == "1");
    CHECK(constant("sqrt(1+tau^2)*sqrt(1+tau^2)-tau^2") == "1");
    CHECK(constant("tanh(tau)+tanh(-tau)") == "0");
    CHECK(constant("cos(tau^2-1)-cos(1-tau^2)") == "0");
    CHECK(constant("1/(tau^2-2)-1/((tau-sqrt(2))*(tau+sqrt(2)))") == "0");
    CHECK(constant("bspline(1,0)+bspline(1,1)+bspline(1,2)") == "1");
}

TEST_CASE("what is odd about the middle of [0, 1] has the integral 0") {
    CHECK(integrates("tanh(tau-1/2)", "1", "0"));
    CHECK(integrates("sin((tau-1/2)^3)", "1", "0"));
    CHECK(integrates("(2*tau-1)*exp(tau-tau^2)", "1", "0"));
    CHECK(integrates("(tau-1/2)^2*atan(tau-1/2)", "1", "0"));
    CHECK(integrates("1/(1+tau)-1/(2-tau)", "1", "0"));
    CHECK(integrates("sqrt(1+tau)-sqrt(2-tau)", "1", "0"));
    CHECK(integrates("cos(pi*tau)*exp((tau-1/2)^2)", "1", "0"));
    CHECK(integrates("1/(1+tau^3)-1/(2-3*tau+3*tau^2-tau^3)", "1", "0"));
}
