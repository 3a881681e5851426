// The general Galerkin form in a basis that is orthogonal for its rule.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "generator/exact/algebra/matrix.hpp"
#include "generator/exact/methods/galerkin_form.hpp"
#include "tests/generator/exact/exact.hpp"

using namespace hvi::gen;

namespace {

DerivedMethod derived(const std::string& basis, const std::string& nodes,
                      const std::string& weights = "") {
    return derive_any(method_from_text(source(basis, "--basis"), source(nodes, "--nodes"),
                                       weights.empty() ? nullptr : source(weights, "--weights")));
}

NumberMatrix diagonal(const NumberVector& entries, bool inverse) {
    NumberMatrix result = zeros(entries.size(), entries.size());
    for (std::size_t j = 0; j < entries.size(); ++j) {
        result[j][j] = inverse ? Number(1) / entries[j] : entries[j];
    }
    return result;
}

/// Checks that phi^T b phi = G is diagonal, and that phi G^-1 phi^T, phi G^-1 A^T and phi G^-1 B,
/// which make the step, equal those of the given basis.
void check_form(const DerivedMethod& method) {
    const auto& rule = std::get<GalerkinRule>(method);
    const GalerkinForm form = galerkin_form(method);
    REQUIRE(form.nodes() == rule.nodes());
    const NumberMatrix b = diagonal(form.b, false), G = diagonal(form.gram, true);
    CHECK(is_zero(transpose(form.phi) * b * form.phi + diagonal(form.gram, false) * Number(-1)));
    const auto known = inverse(rule.gram);
    REQUIRE(known);
    const NumberMatrix given =
        transpose(rule.Psi) * known->adjugate * (Number(1) / known->determinant);
    CHECK(is_zero(form.phi * G * transpose(form.phi) + given * rule.Psi * Number(-1)));
    CHECK(is_zero(form.phi * G * transpose(form.A) + given * transpose(rule.A_psi) * Number(-1)));
    const NumberVector one = form.phi * (G * form.B);
    for (const Number& value : one) { CHECK(value.is_one()); }
}

}  // namespace

TEST_CASE("the orthogonal basis spans what the given one does") {
    check_form(derived("1, tau", "0, 1/2, 1"));
    check_form(derived("1, tau, tau^2", "gauss:4"));
    check_form(derived("tau^2, 1+tau, tau-tau^2", "lobatto:4"));
    check_form(derived("1, tau", "1/4, 1/2, 3/4"));  // a weight of -1/3
}

TEST_CASE("functions without a length of their own have a sum that has one") {
    // sum b tau^2 = sum b (1 - tau)^2 = 0, and sum b tau (1 - tau) = 1/2.
    const DerivedMethod method = derived("tau, 1-tau", "0, 1/2, 1", "-1/2, 2, -1/2");
    CHECK(std::get<GalerkinRule>(method).gram[0][0].is_zero());
    check_form(method);
}

TEST_CASE("for Gauss' rules the orthogonal polynomials are Legendre's") {
    const GalerkinForm form = galerkin_form(derived("1, tau, tau^2", "gauss:4"));
    CHECK(form.B[0].is_one());
    CHECK(form.B[1].is_zero());
    CHECK(form.B[2].is_zero());
    for (std::size_t i = 0; i < form.nodes(); ++i) {  // in the ratio to their first values
        const Number x = Number(2) * form.c[i] - Number(1);
        const Number first = Number(2) * form.c[0] - Number(1);
        CHECK((form.phi[i][1] * first - form.phi[0][1] * x).is_zero());
        const auto P_2 = [](const Number& y) { return Number(3) * y * y - Number(1); };
        CHECK((form.phi[i][2] * P_2(first) - form.phi[0][2] * P_2(x)).is_zero());
    }
}

TEST_CASE("nodes without a weight are left out, and tableaux have a form") {
    const GalerkinForm form =
        galerkin_form(derived("1, tau", "0, 1/4, 1/2, 1", "1/6, 0, 2/3, 1/6"));
    CHECK(form.nodes() == 3);
    CHECK((form.c[1] - Number(1) / Number(2)).is_zero());
    const DerivedMethod lobatto = derive_any(method("lobatto:3"));
    const GalerkinForm nodal = galerkin_form(lobatto);
    CHECK(is_zero(nodal.A + std::get<Tableau>(lobatto).A * Number(-1)));
    CHECK(nodal.phi[1][1].is_one());
    CHECK(nodal.phi[1][0].is_zero());
}

TEST_CASE("a form is symmetric where its nodes, weights and functions are") {
    const auto verdict = [](const DerivedMethod& method) {
        return is_symmetric(galerkin_form(method));
    };
    CHECK(verdict(derived("1, tau", "0, 1/2, 1")).holds);
    CHECK(verdict(derived("1, tau, tau^2", "gauss:5")).holds);
    CHECK(verdict(derive_any(method("gauss:2"))).holds);
    CHECK_FALSE(verdict(derived("1, tau", "0, 2/3, 1")).holds);
    CHECK_FALSE(verdict(derived("1, tau", "radau-left:3")).holds);
    // Symmetric nodes and weights, and a span that is not: the reflection of tau^3 has a tau^2.
    CHECK_FALSE(verdict(derived("1, tau, tau^3", "gauss:4")).holds);
}
