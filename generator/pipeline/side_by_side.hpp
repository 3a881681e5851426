// A stepper of eight trajectories beside a stepper of one.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>

#include "generator/pipeline/stepper.hpp"

namespace hvi::gen {

/// Returns a stepper of eight trajectories that takes the steps of `alone`, with its energy and
/// invariants; nothing where none is built, or where it would not be faster. It iterates fixed
/// points. Precondition: `alone` is made of the other arguments.
[[nodiscard]] std::optional<SceneStepper> stepper_side_by_side(const SceneStepper& alone,
                                                               const Method& method,
                                                               const Scene& scene,
                                                               StepperWishes wishes);

/// Returns one whose trajectories carry a direction along: see tangent_stepper(). Of what is
/// conserved it has the energy alone. Throws as that does.
[[nodiscard]] std::optional<SceneStepper> tangent_stepper_side_by_side(const SceneStepper& alone,
                                                                       const Method& method,
                                                                       const Scene& scene,
                                                                       StepperWishes wishes);

}  // namespace hvi::gen
