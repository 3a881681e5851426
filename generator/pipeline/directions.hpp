// Steppers of a motion and of directions that it carries along.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string_view>

#include "generator/pipeline/stepper.hpp"

namespace hvi::gen {

/// A stepper of the scene's motion and of a direction that it carries along: see with_tangent().
/// Throws InputError, with `what` wishes for it, for a Lagrangian, rotations, scaled time,
/// functions of the user's own and sums that stay loops.
[[nodiscard]] SceneStepper tangent_stepper(const Method& method, const Scene& scene,
                                           StepperWishes wishes, std::string_view what);

/// Makes the header that of a stepper with directions, as hvi::WithDirections has them. Throws as
/// tangent_stepper() does, and for an ensemble. Precondition: the stepper is of these arguments.
void add_directions(SceneStepper& stepper, const Method& method, const Scene& scene,
                    const StepperWishes& wishes);

}  // namespace hvi::gen
