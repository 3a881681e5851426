// The coefficients of the discrete Hamiltonians as series in h: sums over trees without a root.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <memory>

#include "generator/exact/methods/galerkin_rule.hpp"
#include "generator/exact/numbers/ground.hpp"
#include "generator/series/series_trees.hpp"

namespace hvi::gen {

/// H_d^+(q_0, p_1) of (4.19) is the stationary value, over all V and W, of
///
///     p_1 q_0 + h sum_i b_i H(Q^i, P^i) - h^2 sum_ij b_i a_ij W_i V_j,
///     Q^i = q_0 + h sum_j a_ij V_j,    P^i = p_1 + h sum_j (b_j - a~_ij) W_j,
///
/// where V and W are dH/dp and dH/dq on the stages, since b_i (b_j - a~_ij) = b_j a_ji. So it is a
/// sum over trees, each once, of h^vertices weight/symmetry times an elementary Hamiltonian. An
/// arrow joins a derivative by p at one of its vertices to one by q at the other. A vertex is a
/// derivative of H at (q_0, p_1). The weight sums over all placements of vertices on stages: b_i
/// for a vertex on stage i, and a_ij/b_j for an arrow from p on stage j to q on stage i. The exact
/// H_d^+ (4.1) has times in [0,1] in place of stages, and an arrow says that its q is later.
///
/// (4.6) gives the stationary value, over all V and the Y_i = P^i - p_1, of
///
///     p_1 q_0 + h sum_i b_i (H(Q^i, p_1 + Y_i) - Y_i v_i),
///     Q^i = q_0 + h sum_j A_ij V_j,    v_i = sum_j psi_j(c_i) V_j,
///
/// since the rule is exact on the span. The part of Y in the span and V make the arrows, with
/// a_ij/b_j = A_i G^-1 psi(c_j). The rest of Y is orthogonal to all v, and d2H/dp2 alone is its
/// quadratic form. It makes links between two derivatives by p, with the inverse of d2H/dp2, the
/// weight psi(c_i)^T G^-1 psi(c_j) - delta_ij/b_j and the factor 1/h.
class TreeWeight {
public:
    virtual ~TreeWeight() = default;

    [[nodiscard]] virtual Number operator()(const SeriesTree& tree) = 0;
    /// Whether this branch makes the weight of all trees with it 0.
    [[nodiscard]] virtual bool is_nothing(const SeriesTree& branch) = 0;
};
using TreeWeightPointer = std::unique_ptr<TreeWeight>;

/// Returns the weights of (4.1): rational numbers, and 0 for links. The object remembers parts that
/// trees share.
[[nodiscard]] TreeWeightPointer exact_weight(const Ground& ground);

/// Returns the weights of (4.19) or (4.6). Throws MathError where coefficients of the method have
/// no closed form. Precondition: the method is on the field of `ground`.
[[nodiscard]] TreeWeightPointer method_weight(const DerivedMethod& method, const Ground& ground);

}  // namespace hvi::gen
