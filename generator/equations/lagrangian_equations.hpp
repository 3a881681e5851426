// The equations (4.14) of one step, written out for one method and one Lagrangian.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/equations/stage_terms.hpp"
#include "generator/equations/step_title.hpp"
#include "generator/exact/methods/tableau.hpp"
#include "generator/read/lagrangian.hpp"

namespace hvi::gen {

/// An equation for an unknown in its left side, or in both.
struct ImplicitEquation {
    Expression left, right;
};

/// (4.14) in the cardinal basis of the method's nodes, psi_j(c_i) = 1 for i = j and else 0: the
/// span of the basis is the same, so that it is the same step, and the unknowns V^i are the
/// velocities in the stages. Then A_ij = a_ij and B_j = b_j of the tableau, and (4.14d) divided by
/// b_j, which is not 0, is
///
///     dL/dv(Q^j, V^j) = p + h sum_i (b_i - b_i a_ij/b_j) dL/dq(Q^i, V^i) = p + h sum_i a~_ji
///     dL/dq.
struct LagrangianEquations : StepTitle {
    Expression lagrangian;  ///< values put in where it is that of a Hamiltonian
    std::vector<std::string> coordinates, velocities, momenta;
    std::vector<Equation> legendre;   ///< of each momentum: p = dL/dv
    std::vector<Equation> positions;  ///< Q^i (4.14c), as far as L depends on them, and times T_i
    std::vector<ImplicitEquation> velocities_in_stages;  ///< (4.14d)
    std::vector<Equation> update;  ///< of coordinates (4.14a), then of momenta (4.14b)
    bool is_exact = true;          ///< whether each coefficient stands in closed form
};

/// Throws what `derive` and check_regular() throw. Precondition: their names go together (see
/// check_together).
[[nodiscard]] LagrangianEquations lagrangian_equations(const Method& method,
                                                       const Lagrangian& lagrangian);

/// Those of the Lagrangian that belongs to H. Throws what legendre_transform() throws.
[[nodiscard]] LagrangianEquations lagrangian_equations(const Method& method,
                                                       const Hamiltonian& hamiltonian);

}  // namespace hvi::gen
