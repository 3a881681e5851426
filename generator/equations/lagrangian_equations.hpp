// The equations (4.14) of one step, written out for one method and one Lagrangian.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/equations/galerkin_terms.hpp"
#include "generator/equations/step_title.hpp"
#include "generator/read/lagrangian.hpp"

namespace hvi::gen {

/// With as many nodes as functions, (4.14) in the cardinal basis of the nodes, psi_j(c_i) = 1 for
/// i = j and else 0: the span of the basis is the same, so that it is the same step, and the
/// unknowns V^i are the velocities in the stages. Then A_ij = a_ij and B_j = b_j of the tableau,
/// and (4.14d) divided by b_j, which is not 0, is
///
///     dL/dv(Q^j, V^j) = p + h sum_i (b_i - b_i a_ij/b_j) dL/dq(Q^i, V^i) = p + h sum_i a~_ji
///     dL/dq.
///
/// With more nodes (4.14) is in the basis of the method. Positions are Q^i (4.14c) and times T_i,
/// as far as L depends on them, and then the velocities (4.14e); conditions are (4.14d), and the
/// update is (4.14a) and (4.14b).
struct LagrangianEquations : StepTitle, GalerkinEquations {
    Expression lagrangian;  ///< values put in where it is that of a Hamiltonian
    std::vector<std::string> coordinates, velocities, momenta;
    std::vector<Equation> legendre;  ///< of each momentum: p = dL/dv
};

/// Throws what `derive_any` and check_regular() throw. Precondition: their names go together (see
/// check_together).
[[nodiscard]] LagrangianEquations lagrangian_equations(const Method& method,
                                                       const Lagrangian& lagrangian);

/// Those of the Lagrangian that belongs to H. Throws what legendre_transform() throws.
[[nodiscard]] LagrangianEquations lagrangian_equations(const Method& method,
                                                       const Hamiltonian& hamiltonian);

}  // namespace hvi::gen
