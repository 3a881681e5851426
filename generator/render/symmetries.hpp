// The symmetries of a scene, for people and programs.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "generator/symmetry/symmetries.hpp"

namespace hvi::gen {

/// Writes for a terminal of 80 columns.
[[nodiscard]] std::string render_text(const SceneSymmetries& found);

/// Writes the schema `hvi-symmetries/1`.
[[nodiscard]] std::string render_json(const SceneSymmetries& found);

}  // namespace hvi::gen
