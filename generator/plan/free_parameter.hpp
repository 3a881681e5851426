// Parts of a step that depend on a free parameter of its method.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>

#include "generator/exact/methods/tableau.hpp"
#include "generator/ir/one_step_method.hpp"
#include "generator/ir/step.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

/// Throws InputError where the method has a free parameter.
void check_no_parameter(const OneStepMethod& method);

/// Sets Step::from_parameter where coefficients depend on a parameter, and notes the values at
/// which there is no method. Where the parameter cancels, it notes that there is no argument for
/// it. Throws InputError as parametric() does, at the place of the method where there is no other.
/// Precondition: stages, m and times are set.
void set_from_parameter(Step& step, const Tableau& tableau, const std::optional<Place>& method);

}  // namespace hvi::gen
