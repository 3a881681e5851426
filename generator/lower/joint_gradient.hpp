// Both gradients of H at once.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/lower/system.hpp"

namespace hvi::gen {

/// dH/dq, then dH/dp.
[[nodiscard]] std::vector<Scaled> joint_gradient(const SystemGraph& system);

/// Whether a fixed-point iteration of coupled stages is likely to cost less when it evaluates both
/// gradients at the same q and p than when it uses each new slope at once, by the counts of
/// operations.
[[nodiscard]] bool joint_gradient_pays(const SystemGraph& system);

}  // namespace hvi::gen
