// The general Galerkin form (4.6), against a direct solution of its equations, the tableaux that it
// contains, and what it must refuse.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "generator/exact/algebra/matrix.hpp"
#include "generator/exact/methods/galerkin_rule.hpp"
#include "tests/generator/exact/exact.hpp"

using namespace hvi::gen;

namespace {

Method rule(const std::string& basis, const std::string& nodes, const std::string& weights = "") {
    return method_from_text(source(basis, "--basis"), source(nodes, "--nodes"),
                            weights.empty() ? nullptr : source(weights, "--weights"));
}

GalerkinRule derived(const Method& given) { return std::get<GalerkinRule>(derive_any(given)); }

/// x with matrix x = right, by the rule of Cramer's adjugate.
NumberVector solution(const NumberMatrix& matrix, const NumberVector& right) {
    const auto known = inverse(matrix);
    REQUIRE(known);
    return known->adjugate * right * (Number(1) / known->determinant);
}

struct Point {
    Number q, p;
};

/// One step of (4.6a) to (4.6e) as they are printed, for H = (p^2 + q^2)/2: linear equations for
/// V^1 .. V^s and P^1 .. P^r.
Point by_the_paper(const GalerkinRule& given, const Point& x, const Number& h) {
    const std::size_t s = given.functions(), r = given.nodes();
    NumberMatrix equations(s + r, NumberVector(s + r));
    NumberVector right(s + r);
    const auto weight = [&](std::size_t i, std::size_t j) {
        return given.b[i] * (given.B[j] - given.A_psi[i][j]);
    };
    for (std::size_t j = 0; j < s; ++j) {  // (4.6d), with Q^i of (4.6c)
        right[j] = x.p * given.B[j];
        for (std::size_t i = 0; i < r; ++i) {
            equations[j][s + i] = given.b[i] * given.Psi[j][i];
            right[j] = right[j] - h * weight(i, j) * x.q;
            for (std::size_t k = 0; k < s; ++k) {
                equations[j][k] = equations[j][k] + h * h * weight(i, j) * given.A_psi[i][k];
            }
        }
    }
    for (std::size_t j = 0; j < r; ++j) {  // (4.6e)
        for (std::size_t k = 0; k < s; ++k) equations[s + j][k] = given.Psi[k][j];
        equations[s + j][s + j] = Number(-1);
    }
    const NumberVector unknown = solution(equations, right);
    Point end = x;
    for (std::size_t k = 0; k < s; ++k) end.q = end.q + h * given.B[k] * unknown[k];
    for (std::size_t i = 0; i < r; ++i) {
        Number Q = x.q;
        for (std::size_t k = 0; k < s; ++k) Q = Q + h * given.A_psi[i][k] * unknown[k];
        end.p = end.p - h * given.b[i] * Q;
    }
    return end;
}

/// Takes the step with the Nystrom method: f = -q.
Point by_nystrom(const GalerkinRule& given, const Point& x, const Number& h) {
    const auto [A_bar, b_bar] = nystrom(given);
    const std::size_t r = given.nodes();
    NumberMatrix equations = identity(r);
    NumberVector right(r);
    for (std::size_t i = 0; i < r; ++i) {
        right[i] = x.q + h * given.c[i] * x.p;
        for (std::size_t j = 0; j < r; ++j) {
            equations[i][j] = equations[i][j] + h * h * A_bar[i][j];
        }
    }
    const NumberVector Q = solution(equations, right);
    Point end{x.q + h * x.p, x.p};
    for (std::size_t i = 0; i < r; ++i) {
        end.q = end.q - h * h * b_bar[i] * Q[i];
        end.p = end.p - h * given.b[i] * Q[i];
    }
    return end;
}

void check_against_paper(const Method& given) {
    INFO(given.origin);
    const GalerkinRule found = derived(given);
    const Number h = Number(3) / Number(7);
    for (const Point& x : {Point{Number(1), Number(0)}, Point{Number(2) / Number(3), Number(-1)}}) {
        const Point paper = by_the_paper(found, x, h), ours = by_nystrom(found, x, h);
        CHECK((paper.q - ours.q).is_zero());
        CHECK((paper.p - ours.p).is_zero());
    }
}

}  // namespace

TEST_CASE("the Nystrom method takes the steps of (4.6)") {
    check_against_paper(rule("1", "0, 1"));
    check_against_paper(rule("1", "1/4, 3/4"));
    check_against_paper(rule("1, tau", "0, 1/2, 1"));
    check_against_paper(rule("1, tau", "gauss:3"));
    check_against_paper(rule("1, tau", "0, 1/5, 1/2, 4/5, 1"));
    check_against_paper(rule("1, tau", "1/3, 1/2, 3/4"));
    check_against_paper(rule("1, tau, tau^2", "newton-cotes:5"));
    // a weight that is negative, and two that are zero
    check_against_paper(rule("1, tau", "1/4, 1/2, 3/4"));
    check_against_paper(rule("1, tau", "0, 1/4, 1/2, 1", "1/6, 0, 2/3, 1/6"));
    check_against_paper(rule("1, tau", "0, 1/2, 1/2, 1", "1/6, 1/3, 1/3, 1/6"));
    // functions of which 1 is only a combination
    check_against_paper(rule("1 - tau, tau", "0, 1/2, 1"));
    check_against_paper(rule("1, cos(2*pi*tau)", "1/6, 1/2, 5/6", "1/3, 1/3, 1/3"));
}

TEST_CASE("its numbers, by hand") {
    // Simpson's rule and straight velocities: G = (1, 1/2; 1/2, 1/3), and A_i = (c_i, c_i^2/2).
    const GalerkinRule simpson = derived(rule("1, tau", "0, 1/2, 1"));
    CHECK(same(simpson.b, {"1/6", "2/3", "1/6"}));
    CHECK(same(simpson.B, {"1", "1/2"}));
    CHECK(same(simpson.gram[0], {"1", "1/2"}));
    CHECK(same(simpson.gram[1], {"1/2", "1/3"}));
    const auto [A_bar, b_bar] = nystrom(simpson);
    CHECK(same(A_bar[0], {"0", "0", "0"}));
    CHECK(same(A_bar[1], {"1/12", "1/24", "0"}));
    CHECK(same(A_bar[2], {"1/6", "1/3", "0"}));
    CHECK(same(b_bar, {"1/6", "1/3", "0"}));
    // The trapezoidal rule and constant velocities: Stormer-Verlet.
    const GalerkinRule verlet = derived(rule("1", "0, 1"));
    CHECK(same(verlet.b, {"1/2", "1/2"}));
    CHECK(same(verlet.n[0], {"0", "0"}));
    CHECK(same(verlet.n[1], {"1", "0"}));
}

TEST_CASE("the interpolatory weights are those of the rule") {
    CHECK(same(derived(rule("1", "newton-cotes:5")).b, {"7/90", "16/45", "2/15", "16/45", "7/90"}));
    CHECK(same(derived(rule("1", "gauss:3")).b, {"5/18", "4/9", "5/18"}));
    CHECK(same(derived(rule("1", "1/2-sqrt(15)/10, 1/2, 1/2+sqrt(15)/10")).b,
               {"5/18", "4/9", "5/18"}));
    CHECK(same(derived(rule("1", "1/3, 1")).b, {"3/4", "1/4"}));
}

TEST_CASE("weights may have a free parameter, which the method then has") {
    // Exact for 1 and tau whatever w is; G = (1, 1/2; 1/2, (1 + 2 w)/4).
    const GalerkinRule found = derived(rule("1, tau", "0, 1/2, 1", "w, 1 - 2*w, w"));
    CHECK(found.parameters == std::vector<std::string>{"w"});
    CHECK(same(found.gram[1], {"1/2", "(1+2*w)/4"}));
}

TEST_CASE("as many nodes as functions are a tableau, with its own weights or those") {
    CHECK(std::holds_alternative<Tableau>(derive_any(rule("1, tau", "0, 1"))));
    CHECK(std::holds_alternative<Tableau>(derive_any(rule("1, tau", "0, 1", "1/2, 1/2"))));
    const Refusal other = refusal([] { return derive_any(rule("1, tau", "0, 1", "1/3, 2/3")); });
    CHECK(other.status == 1);
    CHECK(other.marked == "[1/3], 2/3");
    CHECK(other.says("node 1, c = 0, is off by -1/6"));
}

TEST_CASE("what is not a method is refused, with the reason") {
    const auto refused = [](const Method& given) {
        return refusal([&] { return derive_any(given); });
    };
    const Refusal fewer = refused(rule("1, tau, tau^2", "0, 1"));
    CHECK(fewer.status == 1);
    CHECK(fewer.says("fewer nodes (2) than basis functions (3)"));
    // sum_i b_i cos(pi c_i) and the integral are 0; of sin(pi tau) Simpson's rule makes 2/3.
    const Refusal inexact = refused(rule("1, sin(pi*tau)", "0, 1/2, 1"));
    CHECK(inexact.status == 1);
    CHECK(inexact.marked == "1, [sin(pi*tau)]");
    CHECK(inexact.says("off by 2/3-2/pi"));
    // tau (tau - 1/2) (tau - 1) vanishes at all nodes of Simpson's rule, as its integral does.
    const Refusal singular = refused(rule("1, tau*(tau-1/2)*(tau-1)", "0, 1/2, 1"));
    CHECK(singular.status == 1);
    CHECK(singular.says("Gram matrix"));
    CHECK(singular.says("tau*(tau-1/2)*(tau-1)"));
    const Refusal constants = refused(rule("tau", "0, 1/2, 1"));
    CHECK(constants.status == 1);
    CHECK(constants.says("constants are not in the span"));
    const Refusal equal = refused(rule("1", "1/2, 1/2"));
    CHECK(equal.status == 1);
    CHECK(equal.says("nodes 1 and 2 are equal"));
    const Refusal count = refused(rule("1", "0, 1/2, 1", "1/2, 1/2"));
    CHECK(count.status == 2);
    CHECK(count.says("2 weights for 3 nodes"));
}
