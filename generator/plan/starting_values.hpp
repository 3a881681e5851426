// Starting values of the iteration of the stage equations.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/ir/step.hpp"
#include "generator/plan/extrapolation.hpp"

namespace hvi::gen {

/// Sets Iteration::extrapolation where it is of use, and notes the reason. Precondition: as for
/// set_solver().
void set_extrapolation(Step& step, const Quadrature& rule);

/// Sets the extrapolation of velocities of the curve and momenta at the nodes. Precondition: the
/// form and the steps of a composition are set.
void set_extrapolation(Step& step, GalerkinStep& galerkin);

}  // namespace hvi::gen
