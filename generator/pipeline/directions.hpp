// Headers of steppers that carry directions along.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "generator/pipeline/stepper.hpp"

namespace hvi::gen {

/// Makes the header that of a stepper with directions, as hvi::WithDirections has them. Throws as
/// tangent_stepper() does, and for an ensemble. Precondition: the stepper is of these arguments.
void add_directions(SceneStepper& stepper, const Method& method, const Scene& scene,
                    const StepperWishes& wishes);

/// A stepper for the directions of a run, whose steps carry them along, or that of
/// tangent_stepper(). Throws as that does; of rotations, which are carried in dual numbers, for
/// functions of the user's own and sums that stay loops. `count`: as many go along at once.
/// Precondition: `stepper` is of these arguments.
[[nodiscard]] SceneStepper stepper_of_directions(const SceneStepper& stepper, const Method& method,
                                                 const Scene& scene, const StepperWishes& wishes,
                                                 std::string_view what, std::size_t count);

/// Returns a stepper of flows of parts of H, whose steps carry the derivative of the motion by a
/// parameter along in dual numbers. Throws InputError for rotations and functions of the user's
/// own. Precondition: `stepper` is of these arguments, and the parameter is one of its system.
[[nodiscard]] SceneStepper stepper_of_parameter(const SceneStepper& stepper, const Method& method,
                                                const Scene& scene, const StepperWishes& wishes,
                                                const std::string& parameter,
                                                std::string_view what);

}  // namespace hvi::gen
