// Costs of a step, before it is written.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/ir/properties.hpp"
#include "generator/ir/step.hpp"

namespace hvi::gen {

/// Returns whether a fixed-point iteration of coupled stages is likely to cost less when it
/// evaluates both gradients at the same q and p than when it uses each new slope at once.
[[nodiscard]] bool joint_gradient_pays(const EvaluationCosts& costs);

/// Returns the operations on each register of stages in lanes.
[[nodiscard]] double operations_of_a_sweep(const Step& step, const SystemProperties& system);

/// Returns the costs of solvers for stages in lanes. Precondition: the step has them.
[[nodiscard]] SolverCosts solver_costs(const Step& step, const SystemProperties& system);

}  // namespace hvi::gen
