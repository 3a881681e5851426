// The coefficients of the discrete Hamiltonians as series in h: sums over trees without a root.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "generator/exact/methods/galerkin_rule.hpp"
#include "generator/exact/methods/trees.hpp"
#include "generator/exact/numbers/ground.hpp"

namespace hvi::gen {

/// H_d^+(q_0, p_1) of (4.19) is the stationary value, over all V and W, of
///
///     p_1 q_0 + h sum_i b_i H(Q^i, P^i) - h^2 sum_ij b_i a_ij W_i V_j,
///     Q^i = q_0 + h sum_j a_ij V_j,    P^i = p_1 + h sum_j (b_j - a~_ij) W_j,
///
/// where V and W are dH/dp and dH/dq on the stages, since b_i (b_j - a~_ij) = b_j a_ji. So it is a
/// sum over trees, each once, of h^vertices weight/symmetry times an elementary Hamiltonian. An
/// edge joins a derivative by q at one of its vertices to one by p at the other, a vertex is a
/// derivative of H at (q_0, p_1), and the weight is that of the vertices on all stages: b_i for a
/// vertex on stage i, and a_ij/b_j for an edge from q on stage i to p on stage j. The exact H_d^+
/// (4.1) is the same with the times in [0,1] for stages, where an edge says that its q is later.
///
/// A tree is written from a vertex in its middle. Below it the vertices on the p of their edge to
/// the middle are f and those on its q are g; the colour of the middle itself says nothing.
using TreeWeight = std::function<Number(const Tree&)>;

/// All trees of a family with 1, 2, ..., `vertices` vertices, each once; `symmetry` is how many
/// automorphisms it has. Other trees have no elementary Hamiltonian for its systems. Precondition:
/// vertices <= most_vertices.
[[nodiscard]] std::vector<std::vector<TreePointer>> unrooted_trees(TreeFamily family, int vertices);

/// Those of (4.1), rational numbers. They remember what trees share, as those of a method do.
[[nodiscard]] TreeWeight exact_weight(const Ground& ground);

/// Those of (4.19); of the general Galerkin form for T = p^T K p/2. Throws MathError where
/// coefficients of the method have no closed form. Precondition: the method is on the field of
/// `ground`.
[[nodiscard]] TreeWeight method_weight(const DerivedMethod& method, const Ground& ground);

}  // namespace hvi::gen
