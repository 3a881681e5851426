// The list of functions of a generated class System.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/emit/system/class_function.hpp"
#include "generator/emit/system/scene_code.hpp"

namespace hvi::gen {

/// Returns the functions of the class in their order, each after the functions that it calls for
/// single sums. Bodies are straight-line code where there are evaluations, else sums with loops;
/// they point into the system.
[[nodiscard]] std::vector<SystemFunction> functions_of_class(const System& system,
                                                             const SceneWishes& wishes,
                                                             const Step& step,
                                                             const Evaluations* evaluations);

/// Returns whether evaluations are counted by System.
[[nodiscard]] bool counts_evaluations(const SceneWishes& wishes, const Step& step);

/// Returns sums that are scattered: derivatives are added where they belong, one summand after the
/// other.
[[nodiscard]] std::vector<const SystemSum*>
scattered_sums(const std::vector<SystemFunction>& functions);

}  // namespace hvi::gen
