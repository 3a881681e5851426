// Statements on the conserved quantities of a scene that a method keeps, beside its certificate.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/symmetry/statements.hpp"

namespace hvi::gen {

/// The symmetries found for a scene, and the statements on a method.
struct SceneStatements {
    std::string name;                      ///< the scene's name
    std::optional<SceneSymmetries> found;  ///< empty where nothing was sought
    std::string left_out;                  ///< why nothing was sought
    std::vector<Statement> statements;
    std::string exception = {};  ///< what each step adds to kept quantities: `, but for ...`
};

/// `conserved`, `not conserved exactly by this method`, ...: what a summary says.
[[nodiscard]] std::string_view keeping_text(Keeping keeping);

}  // namespace hvi::gen
