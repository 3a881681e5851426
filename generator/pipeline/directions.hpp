// Headers of steppers that carry directions along.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/pipeline/stepper.hpp"

namespace hvi::gen {

/// Makes the header that of a stepper with directions, as hvi::WithDirections has them. Throws as
/// tangent_stepper() does, and for an ensemble. Precondition: the stepper is of these arguments.
void add_directions(SceneStepper& stepper, const Method& method, const Scene& scene,
                    const StepperWishes& wishes);

}  // namespace hvi::gen
