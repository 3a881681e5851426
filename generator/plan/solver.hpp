// Choice of the solver of the stage equations.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/ir/properties.hpp"
#include "generator/ir/step.hpp"

namespace hvi::gen {

/// Decides the solver, by the wish and by what can be had; `sweeps` are those of Solver::sweeps.
/// Precondition: the momenta are eliminated where they can be.
void set_solver(Step& step, Solver wished, int sweeps, const SystemProperties& system);

/// Sets corrections with one Hessian, for stages in lanes whose solver is automatic. Precondition:
/// lanes are decided on.
void set_corrections(Step& step, const SystemProperties& system);

/// Returns the iteration of a step; null where no equations are iterated.
[[nodiscard]] Iteration* iteration_of(Step& step);

}  // namespace hvi::gen
