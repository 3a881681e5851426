// The whole way from a method, and a Hamiltonian or none, to a C++ header.
// SPDX-License-Identifier: GPL-2.0-or-later
//
//     text ──read──▶ Method, Scene ──derive──▶ OneStepMethod ──plan──▶ Step ──emit──▶ header
//                          └────────lower────▶ System ─────────┘───────────────┘
//
// read    generator/read            texts to their contents, with the place of every word
// derive  generator/exact/methods   a method to its exact coefficients; nothing is rounded
// lower   generator/lower           H, its derivatives and its structure as one graph without GiNaC
// plan    generator/plan            what a step solves, evaluates, keeps and leaves out, and why;
//                                   its coefficients are rounded here
// emit    generator/emit            these decisions as text
//
// Each stage is a function of the earlier ones alone, and none looks back. Reading is the business
// of the command line. The other stages are called here, and wishes that cannot be fulfilled are
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

/// A stepper for a class of the user, and the records on the way to it.
struct MethodStepper {
    OneStepMethod method;
    Step step;
    std::string header;
};

/// Returns a stepper, which quotes the command line `hvi-gen stepper ...` that writes its header.
/// Throws InputError and MathError as check_composition() and the derivation do. Precondition: the
/// wishes need no scene.
[[nodiscard]] MethodStepper method_stepper(const Method& method, const StepperWishes& wishes);

/// A stepper of a scene, and the records on the way to it.
struct SceneStepper {
    OneStepMethod method;
    System system;
    Step step;
    std::optional<Evaluations> evaluations;  ///< for a system that is written out
    std::string class_name;
    std::string command;  ///< writes the header
    std::string header;
    std::vector<OwnHeader> own_headers;  ///< headers that it needs
    UnrollDecision unrolling = {};
    SceneWishes members = {};    ///< members of its class
    bool has_direction = false;  ///< whether its states are those of with_tangent()
    /// Parameter that the first part of its dual numbers is the derivative by; empty: none.
    std::string differentiated_by = {};
};

/// Returns a stepper of the scene, which quotes the command line `hvi-gen stepper ...` that writes
/// its header. Throws InputError and MathError for an invariant that cannot be a member, and for
/// wishes that are not built for this H. Precondition: wishes.unroll is that of the scene.
[[nodiscard]] SceneStepper scene_stepper(const Method& method, const LoweredScene& scene,
                                         const StepperWishes& wishes);

/// Returns a stepper for a method that is derived already. Precondition: its composition is the one
/// wished for, and no curve is wished for.
[[nodiscard]] SceneStepper scene_stepper(const ExactMethod& method, const LoweredScene& scene,
                                         const StepperWishes& wishes);

/// Lowers the scene for this method alone, and returns its stepper. Where sums stay loops the sizes
/// are parameters of the class. Sums that loops cannot express for this method are written out
/// where that choice is left open. Throws as lowered() does, too. Preconditions: those of lower().
[[nodiscard]] SceneStepper scene_stepper(const Method& method, const Scene& scene,
                                         const StepperWishes& wishes);

/// Throws InputError where a parameter of the method has no value, and is none of the scene.
void check_parameter_of_method(const SceneStepper& stepper);

}  // namespace hvi::gen
