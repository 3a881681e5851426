// The symmetries of scenes without indices.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/read/written_out_scene.hpp"
#include "generator/symmetry/symmetries.hpp"

namespace hvi::gen {

/// By exact algebra, for the values that the scene's parameters have. Throws as affine_symmetries()
/// does, and for more than most_degrees_of_symmetries; and InputError where the scene calls
/// functions of the user's own, of which nothing is known.
[[nodiscard]] SceneSymmetries symmetries_of(const WrittenOutScene& scene);

}  // namespace hvi::gen
