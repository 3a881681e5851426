// Steps in the natural charts of rotations.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>

#include "generator/ir/properties.hpp"
#include "generator/ir/step.hpp"

namespace hvi::gen {

/// Throws MathError for rotations, which the general Galerkin form does not have.
void check_no_rotations(const std::optional<Place>& place, const SystemProperties& system);

/// Makes one block of all stages, whatever zeros the tables have: the momentum of a chart at the
/// start of the step is known when its end is. Precondition: the stages are set.
void set_charts(Step& step);

}  // namespace hvi::gen
