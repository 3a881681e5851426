// Symmetries of scenes whose sums stay sums.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/read/scene.hpp"
#include "generator/symmetry/symmetries.hpp"

namespace hvi::gen {

/// Finds symmetries for all sizes: fields that move all elements of families alike and leave each
/// summand unchanged, and turns of the centre of mass. There may be more of them. An invariant is
/// seen to be conserved where it is a combination of these momentum maps. Throws as system_of() and
/// Algebra do.
[[nodiscard]] SceneSymmetries symmetries_of_families(const Scene& scene);

}  // namespace hvi::gen
