// Where the iteration of the stage equations begins.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/exact/methods/tableau.hpp"
#include "generator/ir/step.hpp"

namespace hvi::gen {

/// Sets Iteration::extrapolation where it is of use, and says why. Precondition: as for
/// set_solver().
void set_extrapolation(Step& step, const Tableau& tableau);

}  // namespace hvi::gen
