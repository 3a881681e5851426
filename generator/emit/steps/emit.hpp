// From a step to the text of a C++ header.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "generator/emit/system/scene_code.hpp"
#include "generator/ir/one_step_method.hpp"
#include "generator/ir/step.hpp"

namespace hvi::gen {

/// Where the solvers are that a step seldom calls; see hvi::detail::Apart.
enum class SeldomSolvers {
    within,  ///< the step
    apart,   ///< in another library
    alone,   ///< the text is that of this library
};

struct EmitOptions {
    std::string class_name;          ///< checked by check_class_name()
    std::string command;             ///< the command line that writes the same header again
    std::string note = {};           ///< a line below that; or empty
    const System* system = nullptr;  ///< whose H it is; null: that of a class of the user
    SceneWishes wishes = {};         ///< of the scene
    const Evaluations* evaluations = nullptr;  ///< of a system that is written out
    SeldomSolvers seldom = SeldomSolvers::within;
    std::string parameters_of = {};  ///< a class before this one with these parameters; or empty
};

/// Whether the step has solvers that it seldom calls.
[[nodiscard]] bool has_seldom_solvers(const Step& step);

/// The header: one class hvi::generated::CLASS_NAME. A function of its arguments and of the version
/// of the program alone. Precondition: `step` is plan(method, ...).
[[nodiscard]] std::string emit(const OneStepMethod& method, const Step& step,
                               const EmitOptions& options);

/// The header without its first comment and without `#pragma once`: what it includes, and the class.
[[nodiscard]] std::string emit_class(const OneStepMethod& method, const Step& step,
                                     const EmitOptions& options);

}  // namespace hvi::gen
