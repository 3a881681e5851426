// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/methods/rule_properties.hpp"

#include <vector>

#include "generator/exact/methods/galerkin_form.hpp"
#include "generator/exact/methods/projected_stages.hpp"

namespace hvi::gen {
namespace {

Verdict exactly(bool holds) { return {holds, true}; }

/// Returns whether n(x, y) - n(y, x) = x - y, which implies the conditions.
Verdict is_symplectic_over_rationals(const RationalMatrix& n) {
    RationalMatrix x = n - n;
    fmpq_one(x.entry(1, 0));
    return exactly(n - transpose(n) == x - transpose(x));
}

/// Returns whether P and its roots, and with them the weights, are mapped to themselves by 1 - x,
/// and n(1 - x, 1 - y) = n(y, x).
Verdict is_symmetric_over_rationals(const RationalRule& rule) {
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

}  // namespace

Verdict is_symplectic(const GalerkinRule& rule) {
    if (rule.over_rationals) {
        return is_symplectic_over_rationals(ProjectedStages(*rule.over_rationals).positions());
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

/// NOTE: of equal nodes only one is found; then a no is not proved.
Verdict is_symmetric(const GalerkinRule& rule) {
    if (rule.over_rationals) { return is_symmetric_over_rationals(*rule.over_rationals); }
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

}  // namespace hvi::gen
