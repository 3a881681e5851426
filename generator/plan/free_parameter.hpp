// What of a step depends on a free parameter of its method.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>

#include "generator/exact/methods/tableau.hpp"
#include "generator/ir/one_step_method.hpp"
#include "generator/ir/step.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

/// Throws InputError for one.
void check_no_parameter(const OneStepMethod& method);

/// Sets Step::from_parameter where coefficients depend on one, and says at which values there is no
/// method; where it cancels, that there is no argument for it. Throws InputError, at the place of
/// the method where there is no other, as parametric() does. Precondition: stages, m and times are
/// set.
void set_from_parameter(Step& step, const Tableau& tableau, const std::optional<Place>& method);

}  // namespace hvi::gen
