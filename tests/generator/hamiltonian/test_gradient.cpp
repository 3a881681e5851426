// SPDX-License-Identifier: GPL-2.0-or-later
#include <random>

#include <catch2/catch.hpp>

#include "generator/hamiltonian/gradient.hpp"
#include "tests/generator/hamiltonian/dual.hpp"
#include "tests/generator/hamiltonian/hamiltonians.hpp"
#include "tests/generator/read/refusal.hpp"

using namespace hvi::gen;

namespace {

Hamiltonian read(const std::string& text, const std::string& coordinates = {},
                 const std::string& momenta = {}) {
    return coordinates.empty()
               ? hamiltonian_from_text(source(text))
               : hamiltonian_from_text(source(text), source(coordinates), source(momenta));
}

std::string by_q(const std::string& text) {
    return to_text(gradient(read(text)).by_coordinates.at(0));
}

std::string by_x(const std::string& text) {
    return to_text(gradient(read(text, "x, y", "px, py")).by_coordinates.at(0));
}

Refusal refused(const std::string& text) {
    return refusal([&] { return gradient(read(text)); });
}

/// Compares with automatic differentiation at random points between `low` and `high`.
void check_values(const Hamiltonian& H, Real low = 0.1L, Real high = 0.9L) {
    static std::mt19937 random(20240607);
    std::uniform_real_distribution<double> between(static_cast<double>(low),
                                                   static_cast<double>(high));
    const Gradient exact = gradient(H);
    const std::vector<std::string> names = variables(H);
    for (int trial = 0; trial < 10; ++trial) {
        Point point;
        for (const std::string& name : names) point[name] = {static_cast<Real>(between(random))};
        for (const std::string& name : parameter_names(H))
            point[name] = {static_cast<Real>(between(random))};
        for (const Parameter& known : H.parameters) point[known.name] = evaluate(known.value, {});
        for (std::size_t i = 0; i < names.size(); ++i) {
            const std::size_t n = H.degrees_of_freedom();
            const Expression& derivative =
                i < n ? exact.by_coordinates[i] : exact.by_momenta[i - n];
            point[names[i]].slope = 1;
            const Real expected = evaluate(H.expression, point).slope;
            point[names[i]].slope = 0;
            const Real found = evaluate(derivative, point).value;
            CAPTURE(to_text(H.expression), names[i], to_text(derivative), found, expected);
            CHECK(std::abs(found - expected) <= 1e-15L * (1 + std::abs(expected)));
        }
    }
}

}  // namespace

TEST_CASE("derivatives agree with automatic differentiation") {
    for (const char* const text : hamiltonians) { check_values(read(text)); }
}

TEST_CASE("derivatives of Hamiltonians of several bodies") {
    check_values(read("(px^2+py^2)/2 - mu/sqrt(x^2+y^2)", "x, y", "px, py"));
    check_values(read("(p1^2+p2^2)/2 + (q1^2+q2^2)/2 + q1^2*q2 - q2^3/3"));
    check_values(read("(p1^2/sin(q2)^2 + p2^2)/(2*m*l^2) - m*g*l*cos(q2)"));
    std::string chain = "p1^2/2";
    for (int k = 2; k <= 12; ++k) {
        const std::string here = std::to_string(k), before = std::to_string(k - 1);
        chain += "+p" + here + "^2/2+exp(q" + before + "-q" + here + ")";
    }
    check_values(read(chain));
}

TEST_CASE("a value of a parameter takes its place") {
    Method method = named_method(source("midpoint"));
    Hamiltonian H = read("p^2/2 + w^2*q^2/2 + b*q");
    set_parameter(method, H, parse_parameter(source("w=sqrt(2)")));
    CHECK(to_text(gradient(H).by_coordinates[0]) == "b+2*q");
    check_values(H);
}

TEST_CASE("derivatives are written as one would write them") {
    CHECK(by_q("p^2/2 - cos(q)") == "sin(q)");
    CHECK(by_q("m*g*l*(1-cos(q))") == "g*l*m*sin(q)");
    CHECK(by_q("w^2*q^2/2") == "w^2*q");
    CHECK(by_q("k*q^2/(2*m)") == "k*q/m");
    CHECK(by_q("q^2/2 + q^4/4") == "q+q^3");
    CHECK(by_q("q^4/4 - q^2/2") == "q^3-q");
    CHECK(by_q("(q^2-1)^2/4") == "q*(q^2-1)");
    CHECK(by_q("(1-q^2)^2/4") == "q*(q^2-1)");
    CHECK(by_q("sqrt(1-q^2)") == "-q/sqrt(1-q^2)");
    CHECK(by_q("-1/q") == "1/q^2");
    CHECK(by_q("q^n") == "n*q^(n-1)");
    CHECK(by_q("d*(1-exp(-a*q))^2") == "2*a*d*(1-exp(-a*q))*exp(-a*q)");
    CHECK(by_q("exp(-2*q)+exp(q)*exp(q)") == "2*exp(2*q)-2*exp(-2*q)");
    CHECK(by_q("(p-q)^3") == "-3*(q-p)^2");
    CHECK(by_q("log(q)/pi") == "1/(pi*q)");
    CHECK(by_q("e*q+e^2*q^2/2") == "e+e^2*q");
    CHECK(by_q("5*p") == "0");
    CHECK(by_q("0.25*q") == "1/4");
    CHECK(by_q("sqrt(2)*q^2") == "2*sqrt(2)*q");
    CHECK(by_q("sqrt(k/m)*q^2/2") == "sqrt(k/m)*q");
    CHECK(by_q("q^2*cos(a)*(m+l)") == "2*(l+m)*cos(a)*q");
    CHECK(by_x("-1/sqrt(x^2+y^2)") == "x/(x^2+y^2)^(3/2)");
    CHECK(by_x("-mu/((x-a)^2+(y-b)^2)^(1/2)") == "mu*(x-a)/((x-a)^2+(y-b)^2)^(3/2)");
    CHECK(by_x("x^2/2 + x^2*y - y^3/3") == "x+2*x*y");
}

TEST_CASE("variables stand in the order in which they are counted") {
    const Gradient g = gradient(read("(q10+q9+q2+q1)^2*p1"));
    CHECK(to_text(g.by_momenta[0]) == "(q1+q2+q9+q10)^2");
}

TEST_CASE("what has no value, with its place") {
    CHECK(refused("p^2 + q/0").marked == "p^2 + q/[0]");
    CHECK(refused("p^2 + 1/(q-q)").marked == "p^2 + 1/[(q-q)]");
    CHECK(refused("(q-q)^-2").status == 2);
    CHECK(refused("q*sqrt(-1)").marked == "q*[sqrt(-1)]");
    CHECK(refused("q*sqrt(-1)").status == 1);
    CHECK(refused("q+log(-2)").status == 1);
    CHECK(refused("q+(-8)^(1/3)").status == 1);
    CHECK(refused("q*asin(2)").status == 1);
    CHECK(refused("q+log(q-q)").says("no value"));
    CHECK(refused("q/(sqrt(2)^2-2)").marked == "q/[(sqrt(2)^2-2)]");
}

TEST_CASE("what is not real, or not defined, for any value of the variables") {
    for (const std::string given :
         {"(-3)^q", "(-p/p)^(1/2)", "log(w-(w+0.1))*q", "sqrt(q-q-2)", "(-8*q/q)^(1/3)"}) {
        CAPTURE(given);
        CHECK(refused(given).status == 1);
        CHECK(refused(given).says("not real"));
    }
    CHECK(refused("p + ((1/2-p/(2*p))*q)^n").marked == "p + [((1/2-p/(2*p))*q)]^n");
    CHECK(refused("sin(pi)^q").status == 2);
    CHECK(refused("(p-p)^2*q").status == 0);
}

TEST_CASE("what is too large is refused at once") {
    const auto repeated = [](const std::string& piece, int times) {
        std::string text;
        for (int k = 0; k < times; ++k) text += piece;
        return text;
    };
    CHECK(refused("q^1e100").says("larger than any Hamiltonian needs"));
    CHECK(refused("q^(10^10)").status == 2);
    CHECK(refused("(2*q)^1000").status == 0);
    CHECK(refused("((2*q)^1000)^1000").status == 2);
    std::string tower = "q";
    for (int k = 0; k < 30; ++k) tower = "(1+p*(" + tower + ")^999)";
    CHECK(refused(tower).status == 0);
    tower = "q";
    for (int k = 0; k < 30; ++k) tower = "(" + tower + ")^999";
    CHECK(refused(tower).status == 0);
    CHECK(refused("((2*q+4*p)^1000)^1000").status == 2);
    CHECK(refused("10^1000000*q").status == 2);
    CHECK(refused("q" + repeated("*9^999", 5000)).status == 2);
    std::string product = "q";
    for (int k = 1; k < 4000; ++k) product += "*sin(q+" + std::to_string(k) + ")";
    CHECK(refused(product).says("too long"));
    CHECK(refused(repeated("sin(", 150) + "q" + repeated(")", 150)).status == 0);
    CHECK(refused("q" + repeated("^q", 150)).status == 0);
    CHECK(refused("q" + repeated("+q^2*p", 9000)).status == 0);
}
