// Whether a scene can begin.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/read/scene.hpp"

namespace hvi::gen {

/// Throws MathError, with its place, where an initial value, or H or an invariant at the start, is
/// provably no real number: the root of a negative number, a division by a mass of zero, two bodies
/// at one place. Does nothing where the scene has no initial data.
void check_start(const Scene& scene);

}  // namespace hvi::gen
