// Steppers of what passes make of a scene.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "generator/pipeline/stepper.hpp"

namespace hvi::gen {

/// Throws InputError, with `what` wishes for it, for functions of the user's own.
void check_own_functions(const Scene& scene, std::string_view what);

/// Throws InputError, with `what` wishes for it, for what has no steps of another function of the
/// scene, as of a direction along it: rotations, and functions of the user's own.
void check_motion(const Scene& scene, std::string_view what);

/// A stepper of the scene's motion and of a direction that it carries along: see with_tangent(). Of
/// scaled time both have a time and its momentum. Throws InputError, with `what` wishes for it, for
/// rotations and functions of the user's own.
[[nodiscard]] SceneStepper tangent_stepper(const Method& method, const Scene& scene,
                                           const StepperWishes& wishes, std::string_view what);

/// A stepper of the scene's motion and of its derivative by a parameter: see with_sensitivity(). In
/// scaled time both have a time and its momentum, which begins as -H and its derivative. Throws
/// as tangent_stepper() does, and for scaled time where sums stay loops. Precondition: the scene
/// has the parameter, and a program can change it.
[[nodiscard]] SceneStepper sensitivity_stepper(const Method& method, const Scene& scene,
                                               const StepperWishes& wishes,
                                               const std::string& parameter, std::string_view what);

/// A stepper of the scene's motion whose steps tell the modified Hamiltonian of the method: see
/// with_homogeneous_extension(). Throws InputError as tangent_stepper() does, and for scaled time,
/// a Lagrangian, sums that stay loops, and methods with more nodes than functions. Precondition: H
/// does not depend on the time.
[[nodiscard]] SceneStepper shadow_stepper(const Method& method, const Scene& scene,
                                          const StepperWishes& wishes, std::string_view what);

/// A stepper of H + e, in which the time t is one coordinate more and e its momentum, which begins
/// as -H: so its energy, H + e, is H - H(0) - the integral of dH/dt by t alone. Throws as
/// shadow_stepper() does. Precondition: H depends on the time.
[[nodiscard]] SceneStepper balance_stepper(const Method& method, const Scene& scene,
                                           const StepperWishes& wishes, std::string_view what);

}  // namespace hvi::gen
