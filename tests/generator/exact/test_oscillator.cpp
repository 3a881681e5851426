// A method's map of the harmonic oscillator.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <random>

#include <catch2/catch.hpp>

#include "generator/exact/algebra/matrix.hpp"
#include "generator/exact/methods/even_map.hpp"
#include "tests/generator/exact/stability.hpp"

using namespace hvi::gen;

namespace {

std::string half_trace(const std::string& given) {
    const auto form = closed_form(map_of(given).half_trace);
    return form ? to_text(*form) : "none";
}

}  // namespace

TEST_CASE("a stage that the step does not use leaves no trace in the map") {
    Tableau tableau;  // the midpoint rule, and a stage of weight 0
    tableau.c = {number("1/2"), number("1/3")};
    tableau.b = {Number(1), Number(0)};
    tableau.A = {{number("1/2"), Number(0)}, {Number(0), number("1/3")}};
    tableau.A_tilde = tableau.A;
    const OscillatorMap map = oscillator_map(tableau);
    CHECK(texts(map.D) == texts(map_of("midpoint").D));
    CHECK(texts(map.m11) == texts(map_of("midpoint").m11));
    CHECK(texts(map.m21) == texts(map_of("midpoint").m21));
}

TEST_CASE("half the trace is written in lowest terms with integers") {
    CHECK(half_trace("stormer-verlet") == "(-z^2+2)/2");
    CHECK(half_trace("lobatto:3") == "(z^4-22*z^2+48)/(2*z^2+48)");
    CHECK(half_trace("chebyshev:3") == "(-z^6+228*z^4-4320*z^2+9216)/(z^6-12*z^4+288*z^2+9216)");
    CHECK(half_trace("1, tau, exp(tau^2) | 0, 1/2, 1") == "none");
}

TEST_CASE("the two ways to the map agree") {
    std::mt19937 generator(20240607);
    for (const std::string method : {"monomials:2", "monomials:3", "monomials:4"}) {
        std::vector<long> nodes;
        while (nodes.size() < static_cast<std::size_t>(method.back() - '0')) {
            const auto node = static_cast<long>(generator() % 98U);
            if (std::find(nodes.begin(), nodes.end(), node) == nodes.end()) {
                nodes.push_back(node);
            }
        }
        std::string list;
        for (const long node : nodes) {
            list += (list.empty() ? "" : ", ") + std::to_string(node) + "/97";
        }
        CAPTURE(list);
        Tableau tableau = derive(any_method(method + "|" + list));
        REQUIRE(tableau.node_polynomial() != nullptr);
        const OscillatorMap by_polynomials = oscillator_map(tableau);
        tableau.galerkin.reset();
        const OscillatorMap by_stages = oscillator_map(tableau);
        CHECK(proved_one(by_polynomials));
        CHECK(proved_one(by_stages));
        CHECK(texts(by_polynomials.D) == texts(by_stages.D));
        CHECK(texts(by_polynomials.m11) == texts(by_stages.m11));
        CHECK(texts(by_polynomials.m12) == texts(by_stages.m12));
        CHECK(texts(by_polynomials.m21) == texts(by_stages.m21));
        CHECK(texts(by_polynomials.m22) == texts(by_stages.m22));
    }
}

TEST_CASE("with a free parameter the map in the basis is that of the stages") {
    for (const std::string method :
         {"1, cos(w*tau), sin(w*tau) | 0, 1/2, 1", "1, exp(w*tau) | 1/5, 2/3",
          "1, cos(w*tau), sin(w*tau) | gauss:3", "1, cos(w*tau), tau | 0, 1/3, 1"}) {
        CAPTURE(method);
        const Tableau given = derive(any_method(method));
        Tableau coefficients = given;
        coefficients.galerkin.reset();
        const OscillatorMap in_basis = oscillator_map(given);
        const OscillatorMap by_stages = oscillator_map(coefficients);
        CHECK(proved_one(in_basis));
        CHECK(proved_one(by_stages));
        CHECK(in_basis.proved);
        CHECK(texts(in_basis.D) == texts(by_stages.D));
        CHECK(texts(in_basis.m11) == texts(by_stages.m11));
        CHECK(texts(in_basis.m12) == texts(by_stages.m12));
        CHECK(texts(in_basis.m21) == texts(by_stages.m21));
        CHECK(texts(in_basis.m22) == texts(by_stages.m22));
    }
}

TEST_CASE("four stages with a free parameter have a map in the basis") {
    const std::string functions = "1, tau, cos(w*tau), sin(w*tau)";
    const Tableau symbolic = derive(any_method(functions + " | gauss:4"));
    REQUIRE_FALSE(takes_long(symbolic));
    CHECK(term_count_in_basis(*symbolic.galerkin, symbolic.b) < 500);
    CHECK(term_count(symbolic.A_tilde * symbolic.A) > 10000);  // by the stages it takes minutes
    const OscillatorMap map = oscillator_map(symbolic);
    CHECK(map.proved);
    CHECK(proved_one(map));
    CHECK(texts(map.m11) == texts(map.m22));  // the method is its own adjoint
    CHECK(map.half_trace.denominator.size() == 9);
    CHECK(takes_long(derive(any_method("1, tau, tau^2, cos(w*tau), sin(w*tau) | gauss:5"))));

    // For a value of the parameter the coefficients are enclosed, and the map is that of the
    // stages.
    const Tableau with_value = derive(any_method("1, tau, cos(2*tau), sin(2*tau) | gauss:4"));
    const EvenMap exact = even_map_in_basis(*with_value.galerkin, with_value.b);
    const OscillatorMap enclosed = oscillator_map(with_value);
    for (std::size_t k = 0; k < exact.D.size(); ++k) {
        CAPTURE(k);
        CHECK((exact.D[k] / exact.D[0]).decimal(30) == enclosed.D[2 * k].decimal(30));
        CHECK((exact.m11[k] / exact.D[0]).decimal(30) == enclosed.m11[2 * k].decimal(30));
    }
}

TEST_CASE("coefficients too long for exact arithmetic are enclosed") {
    const OscillatorMap map = map_of("1, tau, cos(pi*tau), sin(pi*tau) | gauss:4");
    CHECK_FALSE(map.determinant_one.proved);
    CHECK_FALSE(map.proved);
    CHECK(linear_stability(map, 20).stable.front().high.decimal(8) == "3.1382429");
}

TEST_CASE("a free parameter stays in the map") {
    const std::string form = half_trace("1, cos(w*tau), sin(w*tau) | 0, 1/2, 1");
    CHECK(form.find('w') != std::string::npos);
    CHECK(proved_one(map_of("1, cos(w*tau), sin(w*tau) | 0, 1/2, 1")));
}

// ---- methods that are not of Algorithm 4.3 ----

TEST_CASE("a Runge-Kutta method takes x to R(i z) x on the oscillator") {
    // R(w) = 1 + w + w^2/2 + w^3/6 + w^4/24
    const OscillatorMap map = oscillator_map(kutta_4());
    CHECK(same_quotient(map.m11, map.D, "1-z^2/2+z^4/24", "1"));
    CHECK(same_quotient(map.m12, map.D, "z-z^3/6", "1"));
    CHECK(same_quotient(map.m21, map.D, "-z+z^3/6", "1"));
    CHECK(same_quotient(map.m22, map.D, "1-z^2/2+z^4/24", "1"));
    CHECK(map.proved);
    CHECK_FALSE(map.determinant_one.holds);
    CHECK(map.determinant_one.proved);
}

TEST_CASE("weights for p of their own move p") {
    // Q = q + h/2 p, P = p - h/2 q for both; q1 takes P with weight 1, p1 takes Q with weight 2.
    PartitionedMethod method = runge_kutta({{"1/2"}}, {"1"});
    method.b_tilde = {number("2")};
    const OscillatorMap map = oscillator_map(method);
    CHECK(same_quotient(map.m11, map.D, "4-z^2", "4+z^2"));
    CHECK(same_quotient(map.m12, map.D, "4*z", "4+z^2"));
    CHECK(same_quotient(map.m21, map.D, "-8*z", "4+z^2"));
    CHECK(same_quotient(map.m22, map.D, "4-3*z^2", "4+z^2"));
}

TEST_CASE("rational, exact and enclosed coefficients give the same map") {
    // A and A~ are the same numbers, but known in different ways.
    const PartitionedMethod rational =
        runge_kutta({{"1/3", "-1/12"}, {"3/4", "1/4"}}, {"3/4", "1/4"});
    PartitionedMethod radical = rational;
    radical.A[0][0] =
        on_new_ground([](const Ground& ground) { return read("1/3+sqrt(2)", ground); });
    PartitionedMethod back = radical;
    back.A[0][0] = radical.A[0][0];
    const OscillatorMap map = oscillator_map(rational);
    CHECK(text(map.D.back()) != "none");
    const OscillatorMap other = oscillator_map(radical);
    CHECK(other.D.size() == map.D.size());
    // At sqrt(2) -> 0 they agree: the coefficient of z^2 in D is the trace of A~ A, linear in a_11.
    const Number difference = other.D[2] - map.D[2];
    CHECK(text(difference) == "sqrt(2)/3");
}
