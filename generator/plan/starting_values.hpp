// Where the iteration of the stage equations begins.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/ir/step.hpp"
#include "generator/plan/extrapolation.hpp"

namespace hvi::gen {

/// Sets Iteration::extrapolation where it is of use, and says why. Precondition: as for
/// set_solver().
void set_extrapolation(Step& step, const Quadrature& rule);

/// The same for velocities of the curve and momenta at the nodes. Precondition: the form and the
/// steps of a composition are set.
void set_extrapolation(Step& step, GalerkinStep& galerkin);

}  // namespace hvi::gen
