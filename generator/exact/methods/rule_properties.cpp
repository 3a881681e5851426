// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/methods/rule_properties.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include "generator/exact/algebra/matrix.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {
namespace {

/// Of each node the one at 1 - c; empty where there is none.
std::optional<std::vector<std::size_t>> mirrored(const NumberVector& c, Verdict& evidence) {
    std::vector<std::size_t> result;
    for (const Number& node : c) {
        const auto partner = std::find_if(c.begin(), c.end(), [&](const Number& other) {
            const Verdict verdict = vanishes(node + other - Number(1));
            if (verdict.holds) { evidence = evidence && verdict; }
            return verdict.holds;
        });
        if (partner == c.end()) { return std::nullopt; }
        result.push_back(static_cast<std::size_t>(partner - c.begin()));
    }
    return result;
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

/// NOTE: of equal nodes only one is found; then a no is not proved.
Verdict is_symmetric(const GalerkinRule& rule) {
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

}  // namespace hvi::gen
