// A system with loops, from a scene with sums.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/ir/system.hpp"
#include "generator/read/scene.hpp"

namespace hvi::gen {

/// Returns H or L with its sums as loops, its derivatives, and all else of a scene. Throws
/// InputError for a word without a meaning and for an index that leaves its range for some value of
/// the indices of its sums, NoLoops for parts that are not built for systems of any size, and
/// MathError for a number that is not real.
[[nodiscard]] System loop_system(const Scene& scene);

}  // namespace hvi::gen
