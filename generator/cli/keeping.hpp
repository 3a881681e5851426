// Quantities of a scene that a splitting keeps.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/read/scene.hpp"
#include "generator/symmetry/statements.hpp"

namespace hvi::gen {

/// Adds to the facts of a splitting whose steps are flows of parts of H what these keep, or why it
/// makes no steps of the scene. Leaves the facts of other methods as they are.
void add_parts(KeepingFacts& facts, const Method& method, const Scene& scene,
               const UnrollWish& sums, const SceneSymmetries& found);

}  // namespace hvi::gen
