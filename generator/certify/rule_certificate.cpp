// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/certify/rule_certificate.hpp"

#include <algorithm>

#include "generator/exact/algebra/matrix.hpp"
#include "generator/exact/methods/galerkin_form.hpp"
#include "generator/exact/numbers/budget.hpp"

namespace hvi::gen {
namespace {

Verdict is_symplectic(const GalerkinRule& rule) {
    const auto [A_bar, b_bar] = nystrom(rule);
    Verdict result;
    for (std::size_t i = 0; i < rule.nodes() && result.holds; ++i) {
        result = result && vanishes(b_bar[i] - rule.b[i] * (Number(1) - rule.c[i]));
        for (std::size_t j = 0; j < i; ++j) {
            result = result && vanishes(rule.b[i] * (b_bar[j] - A_bar[i][j]) -
                                        rule.b[j] * (b_bar[i] - A_bar[j][i]));
        }
    }
    return result;
}

/// As a Nystrom method. NOTE: of equal nodes only one is found; then a no is not proved.
Verdict is_symmetric_nystrom(const GalerkinRule& rule) {
    Verdict result;
    const auto sigma = mirrored(rule.c, result);
    if (!sigma) { return {false, true}; }
    for (std::size_t i = 0; i < rule.nodes() && result.holds; ++i) {
        result = result && vanishes(rule.b[(*sigma)[i]] - rule.b[i]);
        for (std::size_t j = 0; j < rule.nodes() && result.holds; ++j) {
            result = result && vanishes(rule.n[(*sigma)[i]][(*sigma)[j]] - rule.n[j][i]);
        }
    }
    return result;
}

/// Then n_ij and n_ji are not both different from zero.
bool is_explicit(const GalerkinRule& rule) {
    for (std::size_t i = 0; i < rule.nodes(); ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
            if (!rule.n[i][j].is_zero() && !rule.n[j][i].is_zero()) { return false; }
        }
    }
    return true;
}

/// Psi, A_psi, B and G of a basis phi with sum_k phi_k = 1: that of the rule, but for the first
/// function of which 1 has a part, and in its place 1 less all others.
struct PartitionOfUnity {
    NumberMatrix A_psi;
    NumberVector B;
    NumberMatrix gram;
};

PartitionOfUnity partition_of_unity(const GalerkinRule& rule) {
    const std::size_t s = rule.functions();
    const auto known = inverse(rule.gram);
    HVI_CHECK(known);
    const NumberVector one = known->adjugate * rule.B * (Number(1) / known->determinant);
    const auto first =
        std::find_if(one.begin(), one.end(), [](const Number& part) { return !part.is_zero(); });
    HVI_CHECK(first != one.end());
    NumberMatrix T = identity(s);  // phi = T psi
    NumberVector& row = T[static_cast<std::size_t>(first - one.begin())];
    for (std::size_t k = 0; k < s; ++k) { row[k] = one[k] - Number(1); }
    row[static_cast<std::size_t>(first - one.begin())] = *first;
    return {rule.A_psi * transpose(T), T * rule.B, T * rule.gram * transpose(T)};
}

}  // namespace

PartitionedMethod partitioned_method(const GalerkinRule& rule) {
    const std::size_t r = rule.nodes(), s = rule.functions();
    const auto [A_psi, B, gram] = partition_of_unity(rule);
    const auto known = inverse(gram);
    HVI_CHECK(known);
    PartitionedMethod method{NumberVector(r + s), NumberVector(r + s), zeros(r + s, r + s),
                             zeros(r + s, r + s)};
    for (std::size_t k = 0; k < s; ++k) { method.b[r + k] = B[k]; }
    for (std::size_t i = 0; i < r; ++i) {
        method.b_tilde[i] = rule.b[i];
        NumberVector moments(s);  // of (4.6d): b_i (B - A_i)
        for (std::size_t k = 0; k < s; ++k) {
            method.A[i][r + k] = A_psi[i][k];
            moments[k] = rule.b[i] * (B[k] - A_psi[i][k]);
        }
        const NumberVector column = known->adjugate * moments * (Number(1) / known->determinant);
        for (std::size_t k = 0; k < s; ++k) { method.A_tilde[r + k][i] = column[k]; }
    }
    return method;
}

bool RuleCertificate::is_proved() const {
    return Findings::is_proved() && symplectic.proved && symmetric.proved && nystrom.proved;
}

RuleCertificate certify(const GalerkinRule& rule, int max_order) {
    RuleCertificate result;
    result.name = rule.provenance.name;
    result.origin = rule.provenance.origin;
    result.parameters = rule.parameters;
    result.stages = rule.nodes();
    result.functions = rule.functions();
    result.symplectic = is_symplectic(rule);
    result.symmetric = is_symmetric_nystrom(rule);
    result.is_explicit = is_explicit(rule);
    const PartitionedMethod method = partitioned_method(rule);
    result.nystrom = nystrom_order(method, max_order);
    set_signs(result, rule.c, rule.b);
    if (!takes_long(method)) { set_oscillator(result, method); }
    return result;
}

AnyCertificate certify(const Method& method, int max_order) {
    try {
        AnyCertificate result = std::visit(
            [&](const auto& derived) -> AnyCertificate { return certify(derived, max_order); },
            derive_any(method));
        auto* const of_tableau = std::get_if<Certificate>(&result);
        if (of_tableau != nullptr && !of_tableau->parameters.empty()) {
            of_tableau->exceptions = exceptions(method, of_tableau->orders.general, max_order);
        }
        return result;
    } catch (const TooLarge& error) {
        throw MathError(error.what(), whole(method.basis.source), error.help());
    }
}

}  // namespace hvi::gen
