// From a step to the text of a C++ header.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "generator/emit/system/loop_code.hpp"
#include "generator/emit/system/scene_code.hpp"
#include "generator/ir/one_step_method.hpp"
#include "generator/ir/step.hpp"

namespace hvi::gen {

struct EmitOptions {
    std::string class_name;           ///< checked by check_class_name()
    std::string command;              ///< the command line that writes the same header again
    const System* system = nullptr;   ///< whose H it is; null: that of a class of the user, or
    const LoopCode* loops = nullptr;  ///< that of a scene with loops
    SceneWishes wishes = {};          ///< of the scene
    const Evaluations* evaluations = nullptr;  ///< of the scene, if there is one
};

/// The header: one class hvi::generated::CLASS_NAME. A function of its arguments and of the version
/// of the program alone. Precondition: `step` is plan(method, ...).
[[nodiscard]] std::string emit(const OneStepMethod& method, const Step& step,
                               const EmitOptions& options);

/// The text of a header in which tables of ours give way to invariants that are members.
[[nodiscard]] std::string with_names_of_user(std::string text, const EmitOptions& options);

}  // namespace hvi::gen
