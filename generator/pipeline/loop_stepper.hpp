// From a method and a scene of any size to a C++ header.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/ir/one_step_method.hpp"
#include "generator/ir/step.hpp"
#include "generator/lower/site_force.hpp"
#include "generator/options/wishes.hpp"
#include "generator/read/indexed_scene.hpp"

namespace hvi::gen {

/// A stepper of a scene with loops, and what was found on the way to it.
struct LoopStepper {
    OneStepMethod method;
    LoopSystem system;
    std::optional<SiteSystem> sites;  ///< where it is a lattice
    Step step;
    std::string class_name;
    std::string header;
    std::vector<OwnHeader> own_headers;  ///< that it needs
};

/// Its size does not depend on those of the scene, which are parameters of the class. Throws
/// InputError and MathError as method_stepper() and loop_system() do, and for what is wished for
/// and not built for systems of any size.
[[nodiscard]] LoopStepper loop_stepper(const Method& method, const IndexedScene& scene,
                                       const StepperWishes& wishes);

}  // namespace hvi::gen
