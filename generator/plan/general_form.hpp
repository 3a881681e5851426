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

/// Throws MathError for H with a row of d2H/dp2 that is zero, and InputError for that of a class of
/// the user.
void check_general_form(const std::optional<Place>& place, const SystemProperties& system);

/// Sets the step for H = p^T K p/2 + U(q): positions alone are solved for, or there are kicks and
/// drifts where no position depends on itself. Nodes without a weight are left out: no slope is
/// taken there. Returns the others.
[[nodiscard]] Quadrature set_rule(Step& step, const GalerkinRule& rule);

}  // namespace hvi::gen
