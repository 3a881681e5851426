// The two gradients of H, or of L, as straight-line code, one by one and at once, and their costs.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/ir/system.hpp"
#include "generator/lower/kernel.hpp"

namespace hvi::gen {

struct GradientKernels {
    Kernel by_q, by_conjugates;
    Kernel joint;               ///< by_q, then by_conjugates
    Kernel by_conjugates_at_q;  ///< at the q of the by_q before it
    std::vector<Node> shared;   ///< what that takes of it, or needs of q alone
};

[[nodiscard]] GradientKernels gradient_kernels(const System& system);

/// What a kernel is given that varies, and is no input.
[[nodiscard]] std::vector<Node> computed_before(const Graph& graph, const Kernel& kernel);

/// By the counts of operations.
[[nodiscard]] EvaluationCosts evaluation_costs(const System& system,
                                               const GradientKernels& kernels);

}  // namespace hvi::gen
