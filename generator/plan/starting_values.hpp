// Starting values of the iteration of the stage equations.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>

#include "generator/ir/step.hpp"
#include "generator/plan/extrapolation.hpp"

namespace hvi::gen {

/// Returns the polynomial whose values are the starting slopes of steps of one size that remember
/// those of two steps; empty where they begin with the slopes at their start. Precondition: no free
/// parameter.
[[nodiscard]] std::optional<SlopePolynomial> starting_polynomial(const Quadrature& rule);

/// Sets Iteration::extrapolation where it is of use, and notes the reason. Precondition: as for
/// set_solver().
void set_extrapolation(Step& step, const Quadrature& rule);

/// Sets the extrapolation of velocities of the curve and momenta at the nodes. Precondition: the
/// form and the steps of a composition are set.
void set_extrapolation(Step& step, GalerkinStep& galerkin);

}  // namespace hvi::gen
