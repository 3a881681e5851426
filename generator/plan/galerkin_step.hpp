// The general Galerkin form (4.6) with its own unknowns, for any H.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/ir/one_step_method.hpp"
#include "generator/ir/properties.hpp"
#include "generator/ir/step.hpp"
#include "generator/plan/plan.hpp"

namespace hvi::gen {

/// Sets the nodes, with their weights, and one block of all unknowns.
void set_nodes(Step& step, const OneStepMethod& method, const GalerkinForm& form);

/// Return gamma_1, ..., gamma_k of a composition, and note it among the decisions; nothing without
/// a composition.
[[nodiscard]] NumberVector steps_in_a_row(const OneStepMethod& method);
void note_composition(Step& step, const OneStepMethod& method);

/// Sets the step, except its solver: the velocities of the curve and the momenta at the nodes,
/// solved for at once. Precondition: no free parameter.
void set_galerkin(Step& step, const OneStepMethod& method, const SystemProperties& system,
                  const StepWishes& wishes);

}  // namespace hvi::gen
