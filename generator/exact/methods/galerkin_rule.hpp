// The general Galerkin form (4.6): more nodes than functions.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "generator/exact/methods/tableau.hpp"

namespace hvi::gen {

struct Ingredients;
struct Method;
struct PartitionedMethod;
struct RationalRule;

/// s functions psi_j and a rule b_i, c_i with r > s nodes that integrates them exactly, and so 1,
/// which is in their span. Letters as in the paper, A_psi for its A; indices are 0-based.
///
/// For H = p^T K p/2 + U(q) the form is a symplectic Nystrom method with r stages. With G = Psi
/// diag(b) Psi^T, dividing (4.6d) by G and inserting it in (4.6e), which then is V = K times it,
/// gives
///
///     Q_i = q + h c_i v + sum_j n_ij W_j,    n_ij = c_i - A_i G^-1 A_j^T,
///     q at the end = q + h v + sum_j (1 - c_j) W_j,
///
/// for v = K p and W_j = -h^2 b_j K dU/dq(Q_j), with the rows A_i of A_psi: A_i G^-1 B = c_i, since
/// G^-1 B are the coefficients of 1 in the basis. As the last term is symmetric, n_ij - n_ji = c_i
/// - c_j.
struct GalerkinRule {
    Provenance provenance;
    std::vector<std::string> parameters;  ///< free symbols in its numbers, sorted

    NumberVector c;      ///< r nodes
    NumberVector b;      ///< their weights; some may be zero or negative
    NumberVector B;      ///< B[j] = integral of psi_j over [0,1]
    NumberMatrix Psi;    ///< Psi[j][i] = psi_j(c_i), s x r
    NumberMatrix A_psi;  ///< A_psi[i][j] = integral of psi_j over [0, c_i], r x s
    NumberMatrix gram;   ///< G[j][k] = sum_i b_i psi_j(c_i) psi_k(c_i), s x s, regular
    NumberMatrix n;      ///< r x r

    /// The rule over Q, for weights that are interpolatory at all roots of a polynomial over Q and
    /// for polynomials over Q. Null otherwise.
    std::shared_ptr<const RationalRule> over_rationals;

    [[nodiscard]] std::size_t functions() const { return B.size(); }
    [[nodiscard]] std::size_t nodes() const { return c.size(); }
};

/// The Nystrom method with its usual letters (Hairer, Lubich & Wanner, Geometric Numerical
/// Integration, Section IV.2.3): A_bar[i][j] = b_j n_ij and b_bar_j = b_j (1 - c_j).
struct NystromTableau {
    NumberMatrix A_bar;
    NumberVector b_bar;
};
[[nodiscard]] NystromTableau nystrom(const GalerkinRule& rule);

/// Returns the form as a symplectic partitioned method of its r stages: A = A_psi G^-1 Psi diag(b)
/// and A~ = (1 1^T - Psi^T G^-1 A_psi^T) diag(b), with the weights b. Its momenta in the stages are
/// K^-1 times the velocities at the nodes.
[[nodiscard]] PartitionedMethod partitioned_method(const GalerkinRule& rule);

/// Returns Psi^T G^-1 Psi diag(b), which projects functions on the nodes onto the span.
[[nodiscard]] NumberMatrix projection(const GalerkinRule& rule);

/// Returns stable text of all numbers, for people and tests.
[[nodiscard]] std::string dump(const GalerkinRule& rule);

/// Returns the rule. The weights are those given, else the interpolatory ones. Throws MathError
/// where two nodes are equal and weights are not given, where constants are not in the span, where
/// the rule is not exact on the span, with its defect, and where G is singular, with the functions;
/// InputError as given_weights() and check_parameters() do. Precondition: more nodes than
/// functions.
[[nodiscard]] GalerkinRule galerkin_rule(const Method& method, const Ingredients& given);

/// A derived METHOD.
using DerivedMethod = std::variant<Tableau, GalerkinRule>;

/// Returns a tableau for as many nodes as functions, else the general form. Throws as derive() and
/// galerkin_rule() do.
[[nodiscard]] DerivedMethod derive_any(const Method& method);

}  // namespace hvi::gen
