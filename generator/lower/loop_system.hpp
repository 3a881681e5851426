// From a scene with sums to a system with loops.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/ir/system.hpp"
#include "generator/read/scene.hpp"

namespace hvi::gen {

/// H or L with its sums for loops, its derivatives, and all else that a scene has. Throws
/// InputError for a word without a meaning and for an index that leaves its range for some value of
/// those of its sums, NoLoops for what is not built for systems of any size, and MathError for a
/// number that is not real.
[[nodiscard]] System loop_system(const Scene& scene);

}  // namespace hvi::gen
