// The two gradients of H, or of L, as straight-line code, one by one and at once.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/ir/system.hpp"
#include "generator/lower/kernel.hpp"

namespace hvi::gen {

struct GradientKernels {
    Kernel by_q, by_conjugates;
    Kernel joint;  ///< by_q, then by_conjugates
};

[[nodiscard]] GradientKernels gradient_kernels(const System& system);

/// Whether a fixed-point iteration of coupled stages is likely to cost less when it evaluates both
/// gradients at the same q and p than when it uses each new slope at once, by the counts of
/// operations.
[[nodiscard]] bool joint_gradient_pays(const System& system, const GradientKernels& kernels);

}  // namespace hvi::gen
