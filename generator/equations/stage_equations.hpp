// The equations (4.18) of one step, written out for one method and one Hamiltonian.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/equations/stage_terms.hpp"
#include "generator/exact/methods/tableau.hpp"
#include "generator/hamiltonian/gradient.hpp"
#include "generator/read/hamiltonian.hpp"

namespace hvi::gen {

struct StageEquations {
    /// Values that a derivative of H depends on, in each stage: `Q_1` for the variable q, and `T_1`
    /// for the time. When is_explicit, they stand in an order of evaluation.
    std::vector<Equation> stages;
    std::vector<Equation> update;  ///< all variables at the end of the step, by their names
    bool is_explicit = false;      ///< whether no equation is to be solved for the stages
    bool is_exact = true;          ///< whether each coefficient has a closed form
};

/// Writes (4.18) with the coefficients of the method and the gradient of this H. Terms with the
/// coefficient 0 are left out; a coefficient without a closed form is a decimal of 20 digits.
[[nodiscard]] StageEquations
stage_equations(const ButcherPair& pair, const Hamiltonian& hamiltonian, const Gradient& gradient);

}  // namespace hvi::gen
