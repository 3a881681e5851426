// The general Galerkin form (4.6) in a basis that is orthogonal for its rule.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "generator/exact/methods/galerkin_rule.hpp"
#include "generator/exact/numbers/verdict.hpp"

namespace hvi::gen {

/// Stage equations (4.6), with W_j = h V_j, of s functions phi_j and r nodes:
///
///     Q_i = q + sum_j A_ij W_j,                   next q = q + sum_j B_j W_j,
///     sum_j b_i phi_ij W_j = h b_i dH/dp(Q_i, P_i),
///     sum_i b_i phi_ij P_i = B_j p + sum_i (B_j - A_ij) Lp_i,   Lp_i = -h b_i dH/dq(Q_i, P_i),
///                                                 next p = p + sum_i Lp_i.
///
/// These equations make the generating function
///
///     p~ (q + sum_j B_j W_j) - sum_i (b_i sum_j phi_ij W_j P_i - h b_i H(Q_i, P_i))
///
/// of the next p~ stationary, so that the step is symplectic for any numbers phi, A, B and b. Any
/// basis of a span gives the same step; in this one sum_i b_i phi_ij phi_ik = 0 for j != k.
struct GalerkinForm {
    NumberVector c;     ///< r nodes
    NumberVector b;     ///< their weights, none of them zero
    NumberMatrix phi;   ///< phi[i][j] = phi_j(c_i), r x s
    NumberMatrix A;     ///< A[i][j] = integral of phi_j over [0, c_i], r x s
    NumberVector B;     ///< B[j] = integral of phi_j over [0, 1]
    NumberVector gram;  ///< gram[j] = sum_i b_i phi_ij^2, none of them zero

    [[nodiscard]] std::size_t nodes() const { return c.size(); }
    [[nodiscard]] std::size_t functions() const { return B.size(); }
};

/// Returns the form without the nodes that have no weight. The basis of a rule is made orthogonal
/// by adding multiples of its functions to others, in their order as far as negative weights allow,
/// and scaled by powers of two. For a tableau phi_j is 1 at node j and 0 at the others. Throws
/// MathError where enclosures do not tell a pivot from zero. Precondition: no free parameter.
[[nodiscard]] GalerkinForm galerkin_form(const DerivedMethod& method);

/// Returns whether a step of -h undoes one of h, for all H.
[[nodiscard]] Verdict is_symmetric(const GalerkinForm& form);

/// Returns for each node the one at 1 - c, and the evidence; empty where a node has none. Of equal
/// nodes only one is found.
[[nodiscard]] std::optional<std::vector<std::size_t>> mirrored(const NumberVector& c,
                                                               Verdict& evidence);

}  // namespace hvi::gen
