// Checks that the rotations of a scene begin as rotations.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/read/written_out_scene.hpp"
#include "generator/scene/value_at.hpp"

namespace hvi::gen {

/// Throws MathError, with the place of the first entry, where R^T R provably differs from 1 by more
/// than half of the digits of a double, or det R is provably not positive. NOTE: entries written
/// with some digits make no exact rotation; a step takes the nearest one. Precondition: `start` has
/// the values of all variables.
void check_rotations(const WrittenOutScene& scene, const SymbolValues& start);

}  // namespace hvi::gen
