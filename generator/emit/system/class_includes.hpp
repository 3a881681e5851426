// Headers that a generated class System needs.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "generator/emit/system/scene_code.hpp"

namespace hvi::gen {

/// Lines of #include for system_text() with these arguments.
[[nodiscard]] std::string includes_of_class(const System& system, const SceneWishes& wishes,
                                            const Step& step, const Evaluations* evaluations);

}  // namespace hvi::gen
