// The list of functions of a generated class System.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/emit/system/class_function.hpp"
#include "generator/emit/system/scene_code.hpp"

namespace hvi::gen {

/// Functions of the class in their order, each after those that it calls for single sums. Bodies
/// are straight-line code where there are evaluations, else sums with loops; they point into the
/// system.
[[nodiscard]] std::vector<SystemFunction> functions_of_class(const System& system,
                                                             const SceneWishes& wishes,
                                                             const Step& step,
                                                             const Evaluations* evaluations);

/// Whether evaluations are counted by System.
[[nodiscard]] bool counts_evaluations(const SceneWishes& wishes, const Step& step);

/// Sums that are scattered: added where they belong, one summand after the other.
[[nodiscard]] std::vector<const SystemSum*>
scattered_sums(const std::vector<SystemFunction>& functions);

}  // namespace hvi::gen
