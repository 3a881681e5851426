// The general Galerkin form (4.6) with its own unknowns, for any H.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/ir/one_step_method.hpp"
#include "generator/ir/properties.hpp"
#include "generator/ir/step.hpp"
#include "generator/plan/plan.hpp"

namespace hvi::gen {

/// The nodes, with their weights, and all of it at once: as one block.
void set_nodes(Step& step, const OneStepMethod& method, const GalerkinForm& form);

/// gamma_1, ..., gamma_k of a composition, and what the decisions say of it; nothing without one.
[[nodiscard]] NumberVector steps_in_a_row(const OneStepMethod& method);
void note_composition(Step& step, const OneStepMethod& method);

/// Sets what the step is made of, but for its solver: the velocities of the curve and the momenta
/// at the nodes, solved for at once. Precondition: no free parameter.
void set_galerkin(Step& step, const OneStepMethod& method, const SystemProperties& system,
                  const StepWishes& wishes);

}  // namespace hvi::gen
