// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/certify/rule_certificate.hpp"

#include <algorithm>

#include "generator/exact/methods/galerkin_form.hpp"
#include "generator/exact/methods/projected_stages.hpp"
#include "generator/exact/numbers/budget.hpp"

namespace hvi::gen {
namespace {

Verdict exactly(bool holds) { return {holds, true}; }

/// n(x, y) - n(y, x) = x - y, which is more.
Verdict is_symplectic(const RationalMatrix& n) {
    RationalMatrix x = n - n;
    fmpq_one(x.entry(1, 0));
    return exactly(n - transpose(n) == x - transpose(x));
}

Verdict is_symplectic(const GalerkinRule& rule) {
    if (rule.over_rationals) {
        return is_symplectic(ProjectedStages(*rule.over_rationals).positions());
    }
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

/// P and its roots, and with them the weights, are mapped to themselves by 1 - x, and
/// n(1 - x, 1 - y) = n(y, x).
Verdict is_symmetric_nystrom(const RationalRule& rule) {
    const RationalPolynomial& P = rule.P;
    if (!(monic(P.at_affine(-1, 1)) == monic(P))) { return exactly(false); }
    std::vector<RationalPolynomial> powers{RationalPolynomial(1)};  // of 1 - x
    const auto r = static_cast<std::size_t>(P.degree());
    while (powers.size() < r) {
        powers.push_back(powers.back() * RationalPolynomial::variable().at_affine(-1, 1));
    }
    const RationalMatrix R = coefficient_rows(powers, r);
    const ProjectedStages stages(rule);
    const RationalMatrix& n = stages.positions();
    return exactly(transpose(R) * n * R == transpose(n));
}

/// As a Nystrom method. NOTE: of equal nodes only one is found; then a no is not proved.
Verdict is_symmetric_nystrom(const GalerkinRule& rule) {
    if (rule.over_rationals) { return is_symmetric_nystrom(*rule.over_rationals); }
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

}  // namespace

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
    result.nystrom = nystrom_order(rule, max_order);
    set_signs(result, rule.c, rule.b);
    if (!takes_long(rule)) { set_oscillator(result, rule); }
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
