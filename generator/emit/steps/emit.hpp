// From a step to the text of a C++ header.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/emit/system/scene_code.hpp"
#include "generator/ir/one_step_method.hpp"
#include "generator/ir/step.hpp"

namespace hvi::gen {

/// Place of the solvers that a step seldom calls; see hvi::detail::Apart.
enum class SeldomSolvers {
    within,  ///< in the header of the step
    apart,   ///< in another library
    alone,   ///< in the text being written, which is that library
};

struct EmitOptions {
    std::string class_name;              ///< checked by check_class_name()
    std::string command;                 ///< the command line that writes the same header again
    std::string note = {};               ///< a line below the command; or empty
    std::vector<std::string> kept = {};  ///< invariants that the flow of each part of H keeps
    const System* system = nullptr;      ///< system of the scene; null: a class of the user
    SceneWishes wishes = {};             ///< members wished for
    const Evaluations* evaluations = nullptr;  ///< for a system that is written out
    SeldomSolvers seldom = SeldomSolvers::within;
    std::string parameters_of = {};  ///< an earlier class whose parameters it takes; or empty
};

/// Returns whether the step has solvers that it seldom calls.
[[nodiscard]] bool has_seldom_solvers(const Step& step);

/// Returns the header with one class hvi::generated::CLASS_NAME. It depends on the arguments and on
/// the version of the program alone. Precondition: `step` is plan(method, ...).
[[nodiscard]] std::string emit(const OneStepMethod& method, const Step& step,
                               const EmitOptions& options);

/// Returns the header without its first comment and `#pragma once`: the includes, and the class.
[[nodiscard]] std::string emit_class(const OneStepMethod& method, const Step& step,
                                     const EmitOptions& options);

}  // namespace hvi::gen
