// Who solves the stage equations.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/ir/step.hpp"

namespace hvi::gen {

/// Decides it from what is wished for and what can be had. Precondition: the momenta are eliminated
/// where they can be. `joint_gradient_pays`: see SystemProperties.
void set_solver(Step& step, Solver wished, bool joint_gradient_pays);

/// Null where no equations are iterated.
[[nodiscard]] Iteration* iteration_of(Step& step);

}  // namespace hvi::gen
