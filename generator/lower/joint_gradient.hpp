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

/// By the counts of operations.
[[nodiscard]] EvaluationCosts evaluation_costs(const System& system,
                                               const GradientKernels& kernels);

}  // namespace hvi::gen
