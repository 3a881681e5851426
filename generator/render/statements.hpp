// What a method keeps of what a scene conserves, beside its certificate.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/symmetry/statements.hpp"

namespace hvi::gen {

/// What was found of a scene, and what a method keeps of it.
struct SceneStatements {
    std::string name;                      ///< of the scene
    std::optional<SceneSymmetries> found;  ///< empty where nothing was looked for
    std::string left_out;                  ///< why
    std::vector<Statement> statements;
};

/// `conserved`, `not conserved exactly by this method`, ...: what a summary says.
[[nodiscard]] std::string_view keeping_text(Keeping keeping);

}  // namespace hvi::gen
