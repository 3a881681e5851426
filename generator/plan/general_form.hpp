// The stages of the general Galerkin form (4.6), for a quadratic kinetic energy.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>

#include "generator/exact/methods/galerkin_rule.hpp"
#include "generator/ir/one_step_method.hpp"
#include "generator/ir/properties.hpp"
#include "generator/ir/step.hpp"
#include "generator/plan/starting_values.hpp"

namespace hvi::gen {

/// Throws MathError for H of which some row of d2H/dp2 is zero, and InputError for that of a class
/// of the user.
void check_general_form(const std::optional<Place>& place, const SystemProperties& system);

/// Sets what the step is made of, for H = p^T K p/2 + U(q): positions alone that are solved for, or
/// kicks and drifts where none depends on itself. Nodes without a weight are left out: no slope is
/// taken there. Returns the others.
[[nodiscard]] Quadrature set_rule(Step& step, const GalerkinRule& rule);

}  // namespace hvi::gen
