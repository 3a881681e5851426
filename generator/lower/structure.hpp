// What a Hamiltonian is made of, as far as its graph proves it.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/lower/system.hpp"

namespace hvi::gen {

/// A block of the Hessian of H; a zero entry is proved to be one.
using HessianBlock = std::vector<std::vector<Scaled>>;

/// The second derivatives of H and what they tell. What is true here is proved: a graph computes by
/// exact algebra, and what it does not see to be constant may be proved so in a field; see
/// constant_value(). What is false may be true and hidden: exp(q) exp(-q) q + p.
struct Structure {
    HessianBlock qq, qp,
        pp;  ///< qp[i][j] is the derivative by q_i and p_j; all in the system's graph

    bool is_separable = false;          ///< H = T(p) + U(q), or T(p) + U(q, t)
    bool kinetic_is_quadratic = false;  ///< and T is quadratic, with a constant matrix pp
    std::vector<Scaled> inverse_mass;   ///< then K p, for T = p^T K p/2 and what is linear in p
    std::vector<Node> direction;        ///< then inputs v_k of their own,
    std::vector<Scaled> qq_along;       ///< and qq v
    bool is_quadratic = false;          ///< all second derivatives are constant
    bool has_linear_map = false;        ///< and H has no t: all steps are one linear map
    std::vector<Scaled> by_q, by_p;     ///< then the first derivatives at q = p = 0
    bool is_linear_in_p = false;        ///< pp is zero, and not all else
    bool is_linear_in_q = false;
    std::vector<std::size_t> cyclic;  ///< the q_i that do not occur, so that p_i stays
};

/// Whether H has terms that are linear in q or p. Precondition: has_linear_map.
[[nodiscard]] bool has_linear_part(const Structure& quadratic);

/// Whether H does not depend on some momentum, or not more than linearly: a row of pp is zero.
[[nodiscard]] bool is_degenerate(const Structure& structure);

/// Adds the second derivatives to the graph.
[[nodiscard]] Structure structure(SystemGraph& system);

}  // namespace hvi::gen
