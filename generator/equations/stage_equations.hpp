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
    /// Of the values that a derivative of H depends on, in each stage: `Q_1` of the variable q, and
    /// `T_1` of the time. In an order in which they can be evaluated, when is_explicit.
    std::vector<Equation> stages;
    std::vector<Equation> update;  ///< of all variables at the end of the step, by their names
    bool is_explicit = false;      ///< whether the stages ask for nothing to be solved
    bool is_exact = true;          ///< whether each coefficient stands in closed form
};

/// (4.18) with the coefficients of the method and the gradient of this H put in. Terms with the
/// coefficient 0 are left out; a coefficient without a closed form is a decimal of 20 digits.
[[nodiscard]] StageEquations
stage_equations(const ButcherPair& pair, const Hamiltonian& hamiltonian, const Gradient& gradient);

}  // namespace hvi::gen
