// Functions of a parameter: their zeros, how they vanish at 0, and quotients of them.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "generator/exact/numbers/expansion.hpp"
#include "generator/exact/parameters/entire.hpp"
#include "generator/exact/parameters/parametric.hpp"
#include "generator/support/error.hpp"
#include "tests/generator/exact/exact.hpp"

using namespace hvi::gen;

namespace {

/// w, sin(w), cos(w), and pi.
EntireGenerators circle(const Number& pi) {
    return {{{Phase::Kind::angle, Number(1), Number(1)}}, {pi}};
}

/// coefficient * w^powers[0] sin(w)^powers[1] cos(w)^powers[2] pi^powers[3]
EntireFunction function(std::vector<EntireFunction::Term> terms) { return {std::move(terms)}; }

const EntireFunction::Term w{1, {1, 0, 0, 0}};
const EntireFunction::Term sine{1, {0, 1, 0, 0}};
const EntireFunction::Term cosine{1, {0, 0, 1, 0}};
EntireFunction::Term minus(EntireFunction::Term term) {
    term.coefficient = -term.coefficient;
    return term;
}

ParametricNumbers of_weights(const char* basis, const char* nodes) {
    return parametric(derive(method(basis, nodes)).b, {});
}

}  // namespace

TEST_CASE("real zeros") {
    const EntireGenerators generators = circle(number("pi"));
    // tan(w) = w: Abramowitz and Stegun, table 4.19.
    const EntireFunction tangent = function({sine, {-1, {1, 0, 1, 0}}});
    const auto zeros = real_zeros(tangent, generators, 12);
    REQUIRE(zeros.size() == 6);
    CHECK(zeros[3] == Approx(4.493409457909064).epsilon(1e-12));
    CHECK(zeros[4] == Approx(7.725251836937707).epsilon(1e-12));
    CHECK(zeros[5] == Approx(10.90412165942890).epsilon(1e-12));
    for (std::size_t i = 0; i < 3; ++i) { CHECK(zeros[i] == Approx(-zeros[5 - i])); }
    CHECK(real_zeros(tangent, generators, 4.4).empty());
    // 1 - sin(w) touches 0 at pi/2.
    const EntireFunction touching = function({{1, {0, 0, 0, 0}}, minus(sine)});
    REQUIRE(real_zeros(touching, generators, 3).size() == 1);
    CHECK(real_zeros(touching, generators, 3).front() == Approx(1.5707963).epsilon(1e-6));
    // (pi - w) w^2.
    const EntireFunction line = function({{1, {2, 0, 0, 1}}, {-1, {3, 0, 0, 0}}});
    REQUIRE(real_zeros(line, generators, 8).size() == 1);
    CHECK(real_zeros(line, generators, 8).front() == Approx(3.141592653589793).epsilon(1e-12));
}

TEST_CASE("orders at 0") {
    const EntireGenerators generators = circle(number("pi"));
    CHECK(order_at_zero(function({cosine}), generators) == 0);
    CHECK(order_at_zero(function({w, minus(sine)}), generators) == 3);
    CHECK(order_at_zero(function({sine, {-1, {1, 0, 1, 0}}}), generators) == 3);
    CHECK(order_at_zero(function({{1, {0, 0, 0, 0}}, minus(cosine)}), generators) == 2);
    // pi^2 (sin^2 + cos^2 - 1) + w^7.
    CHECK(
        order_at_zero(
            function({{1, {0, 2, 0, 2}}, {1, {0, 0, 2, 2}}, {-1, {0, 0, 0, 2}}, {1, {7, 0, 0, 0}}}),
            generators) == 7);
    const EntireGenerators exponential{{{Phase::Kind::exponential, Number(2), Number(2)}}, {}};
    // exp(2 w) - 1 - 2 w.
    CHECK(order_at_zero(EntireFunction{{{1, {0, 1, 0}}, {-1, {0, 0, 1}}, {-2, {1, 0, 1}}}},
                        exponential) == 2);
    // cos(w)^2 + sin(w)^2 - 1 vanishes everywhere.
    CHECK_THROWS_AS(
        order_at_zero(function({{1, {0, 2, 0, 0}}, {1, {0, 0, 2, 0}}, {-1, {0, 0, 0, 0}}}),
                      generators),
        MathError);
}

TEST_CASE("the switch to the series follows from bounds") {
    // The terms of w - sin(w) add up to 2 w and half the leading one is w^3/12: 24/w^2 < 2^40 for w
    // = 2^-17 and not for 2^-18. With the coefficients 3, 5, 7 and 9 the remainder is 12 w^8/11!,
    // below 2^-118; without the coefficient 9 it is 12 w^6/9!, above.
    const SeriesPlan plan = series_plan({function({w, minus(sine)})}, circle(number("pi")));
    CHECK(plan.switch_exponent == -17);
    CHECK(plan.length == 10);
}

TEST_CASE("quotients in lowest terms have no zeros in common") {
    // b_1 = (w - 2 sin(w/2))/(2 w (1 - cos(w/2))), and 1 - cos(w/2) = 2 sin(w/4)^2.
    const ParametricNumbers three = of_weights("1, cos(w*tau), sin(w*tau)", "0, 1/2, 1");
    REQUIRE(three.generators.phases.size() == 1);
    CHECK(text(three.generators.phases[0].rate) == "1/4");
    CHECK(three.at_zero == Zero::harmless);
    REQUIRE(three.zeros.size() == 2);
    CHECK(three.zeros[0].family == "w = 4*pi*k, k = +-1, +-2, ...");
    CHECK(three.zeros[1].zero == Zero::weight);
    const Quotient& first = three.weights[0];
    CHECK(first == three.weights[2]);
    CHECK_FALSE(first == three.weights[1]);
    CHECK(three.functions[first.numerator].order == 3);
    CHECK(three.functions[first.numerator].zero == Zero::weight);
    CHECK(first.exponents == std::vector<unsigned>{1, 2});
    CHECK(text(first.divisor) == "4");
}

TEST_CASE("the parameter 0 may be a pole, or a zero of a weight") {
    CHECK(of_weights("1, tau, tau^2", "0, w, 1").at_zero == Zero::pole);
    // b_2 = (1/2 - c_1)/(c_2 - c_1) = w/(1/2 + w).
    CHECK(of_weights("1, tau", "1/2-w, 1").at_zero == Zero::weight);
    CHECK(of_weights("1, tau/w", "0, 1").at_zero == Zero::harmless);
}

TEST_CASE("what a stepper cannot take as a parameter") {
    CHECK_THROWS_AS(of_weights("1, cos(w^2*tau)", "0, 1"), InputError);
    CHECK_THROWS_AS(of_weights("1, cos(w*tau), cos(v*tau)", "0, 1/2, 1"), InputError);
    CHECK_THROWS_AS(of_weights("1, exp(tau/w)", "0, 1"), InputError);
}

TEST_CASE("expansions are sums of doubles") {
    using Parts = std::array<double, 5>;
    CHECK((expansion(-3) == Parts{-3.0}));
    // 2^53 + 1 and 2^70 + 1.
    CHECK((expansion(number("9007199254740993")) == Parts{0x1p53, 1.0}));
    CHECK((expansion(number("1180591620717411303425")) == Parts{0x1p70, 1.0}));
    // 1/3 = 0x0.555...: each part takes the next 53 bits or more.
    const auto third = expansion(number("1/3"));
    CHECK(third[0] == 0x1.5555555555555p-2);
    CHECK(third[1] == 0x1.5555555555555p-56);
    CHECK(third[4] == 0x1.5555555555555p-218);
    // pi to 161 bits, as in the sources of many libraries.
    const auto pi = expansion(number("pi"));
    CHECK(pi[0] == 0x1.921fb54442d18p+1);
    CHECK(pi[1] == 0x1.1a62633145c07p-53);
    CHECK(pi[2] == -0x1.f1976b7ed8fbcp-109);
}
