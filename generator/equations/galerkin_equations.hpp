// The equations (4.6) of one step of the general Galerkin form, written out for one Hamiltonian.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/equations/galerkin_terms.hpp"
#include "generator/hamiltonian/gradient.hpp"
#include "generator/read/hamiltonian.hpp"

namespace hvi::gen {

/// Writes (4.6) with the numbers of the rule and the gradient of this H: (4.6c) for the unknowns
/// V^j and P^i, Q^i as far as H depends on them, the conditions (4.6d) and (4.6e), and (4.6a),
/// (4.6b). Terms with the coefficient 0 are left out; a coefficient without a closed form is a
/// decimal of 20 digits.
[[nodiscard]] GalerkinEquations galerkin_equations(const GalerkinRule& rule,
                                                   const Hamiltonian& hamiltonian,
                                                   const Gradient& gradient);

}  // namespace hvi::gen
