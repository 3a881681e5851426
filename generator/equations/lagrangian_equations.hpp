// The equations (4.14) of one step, written out for one method and one Lagrangian.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/equations/galerkin_terms.hpp"
#include "generator/equations/step_title.hpp"
#include "generator/read/lagrangian.hpp"

namespace hvi::gen {

/// The equations (4.14). With as many nodes as functions they are in the cardinal basis of the
/// nodes, psi_j(c_i) = 1 for i = j and else 0. Its span is that of the method's basis, so that the
/// step is unchanged, and the unknowns V^i are the velocities in the stages. Then A_ij = a_ij and
/// B_j = b_j of the tableau, and (4.14d) divided by b_j, which is not 0, is
///
///     dL/dv(Q^j, V^j) = p + h sum_i (b_i - b_i a_ij/b_j) dL/dq(Q^i, V^i)
///                     = p + h sum_i a~_ji dL/dq.
///
/// For more nodes (4.14) is in the basis of the method. `positions` are Q^i (4.14c) and times T_i,
/// as far as L depends on them, and then the velocities (4.14e). `conditions` are (4.14d), and
/// `update` is (4.14a) and (4.14b).
struct LagrangianEquations : StepTitle, GalerkinEquations {
    Expression lagrangian;  ///< values put in where it comes from a Hamiltonian
    std::vector<std::string> coordinates, velocities, momenta;
    std::vector<Equation> legendre;  ///< p = dL/dv for each momentum
};

/// Writes the equations for L. Throws as `derive_any` and check_regular() do. Precondition: the
/// names of both go together (see check_together).
[[nodiscard]] LagrangianEquations lagrangian_equations(const Method& method,
                                                       const Lagrangian& lagrangian);

/// Writes the equations for the Lagrangian of H. Throws as legendre_transform() does.
[[nodiscard]] LagrangianEquations lagrangian_equations(const Method& method,
                                                       const Hamiltonian& hamiltonian);

}  // namespace hvi::gen
