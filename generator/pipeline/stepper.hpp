// From a method, and a Hamiltonian or none, to a C++ header: the whole way.
// SPDX-License-Identifier: GPL-2.0-or-later
//
//     text ──read──▶ Method, Scene ──derive──▶ OneStepMethod ──plan──▶ Step ──emit──▶ header
//                          └────────lower────▶ System ─────────┘───────────────┘
//
// read    generator/read            texts to what they say, with the place of every word
// derive  generator/exact/methods   a method to its exact coefficients; nothing is rounded
// lower   generator/lower           H, its derivatives and its structure as one graph without GiNaC
// plan    generator/plan            what a step solves, evaluates, keeps and leaves out, and why;
//                                   its coefficients are rounded here
// emit    generator/emit            these decisions as text
//
// Each is a function of what stands before it alone, and none looks back. Reading is the business
// of the command line; the others are called here, and what was wished for and cannot be had is
// refused between them.
#pragma once

#include <optional>
#include <string>

#include "generator/emit/system/scene_code.hpp"
#include "generator/exact/methods/composed_method.hpp"
#include "generator/ir/one_step_method.hpp"
#include "generator/options/wishes.hpp"
#include "generator/pipeline/lowered.hpp"
#include "generator/plan/evaluations.hpp"

namespace hvi::gen {

/// A stepper for a class of the user, and what was found on the way to it.
struct MethodStepper {
    OneStepMethod method;
    Step step;
    std::string header;
};

/// The command line `hvi-gen stepper ...` that writes the same header is quoted in it. Throws
/// InputError and MathError as check_composition() and the derivation do. Precondition: what is
/// wished for needs no scene.
[[nodiscard]] MethodStepper method_stepper(const Method& method, const StepperWishes& wishes);

/// A stepper of a scene, and what was found on the way to it.
struct SceneStepper {
    OneStepMethod method;
    System system;
    Step step;
    std::optional<Evaluations> evaluations;  ///< of a system that is written out
    std::string class_name;
    std::string command;  ///< that writes the header
    std::string header;
    std::vector<OwnHeader> own_headers;  ///< that it needs
    UnrollDecision unrolling = {};
    SceneWishes members = {};  ///< of its class
};

/// A stepper of the scene. The command line `hvi-gen stepper ...` that writes the same header is
/// quoted in it. Throws InputError and MathError for an invariant that cannot be a member, and for
/// what is wished for and not built for this H. Precondition: wishes.unroll is that of the scene.
[[nodiscard]] SceneStepper scene_stepper(const Method& method, const LoweredScene& scene,
                                         const StepperWishes& wishes);

/// Takes a method that is derived already. Precondition: its composition is wished for, no curve.
[[nodiscard]] SceneStepper scene_stepper(const ExactMethod& method, const LoweredScene& scene,
                                         const StepperWishes& wishes);

/// Lowers the scene for this method alone; then the sizes are parameters of the class where sums
/// stay loops. What loops do not have for this method is written out where that is left open.
/// Throws as lowered() does, too. Preconditions: those of lower().
[[nodiscard]] SceneStepper scene_stepper(const Method& method, const Scene& scene,
                                         const StepperWishes& wishes);

/// A stepper of the scene's motion and of a direction that it carries along: see with_tangent().
/// Throws InputError, with `what` wishes for it, for a Lagrangian, rotations, scaled time,
/// functions of the user's own and sums that stay loops.
[[nodiscard]] SceneStepper tangent_stepper(const Method& method, const Scene& scene,
                                           const StepperWishes& wishes, std::string_view what);

/// A stepper of the scene's motion whose steps tell the modified Hamiltonian of the method: see
/// with_homogeneous_extension(). Throws InputError as tangent_stepper() does, where H depends on the
/// time, and for methods with more nodes than functions.
[[nodiscard]] SceneStepper shadow_stepper(const Method& method, const Scene& scene,
                                          const StepperWishes& wishes, std::string_view what);

/// A stepper of H + e, in which the time t is one coordinate more and e its momentum, which begins
/// as -H: so its energy, H + e, is H - H(0) - the integral of dH/dt by t alone. Nothing where that
/// is not built: for a Lagrangian, rotations, scaled time, functions of the user's own, sums that
/// stay loops, and methods with more nodes than functions, as H + e is linear in e. Precondition: H
/// depends on the time.
[[nodiscard]] std::optional<SceneStepper> balance_stepper(const Method& method, const Scene& scene,
                                                          StepperWishes wishes);

/// Throws InputError where a parameter of the method has no value, and is none of the scene.
void check_parameter_of_method(const SceneStepper& stepper);

}  // namespace hvi::gen
