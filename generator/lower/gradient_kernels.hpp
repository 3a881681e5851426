// Gradients of H, or of L, as straight-line code, one by one and at once, and their costs.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/ir/system.hpp"
#include "generator/lower/kernel.hpp"

namespace hvi::gen {

struct GradientKernels {
    Kernel by_q, by_conjugates;
    Kernel joint;               ///< by_q, then by_conjugates
    Kernel by_conjugates_at_q;  ///< at the same q as the by_q before it
    std::vector<Node> shared;   ///< values of q alone that by_conjugates_at_q takes or needs
};

[[nodiscard]] GradientKernels gradient_kernels(const System& system);

/// Returns the nodes that a kernel is given that vary, and are no inputs.
[[nodiscard]] std::vector<Node> computed_before(const Graph& graph, const Kernel& kernel);

/// Returns the costs, from the counts of operations.
[[nodiscard]] EvaluationCosts evaluation_costs(const System& system,
                                               const GradientKernels& kernels);

}  // namespace hvi::gen
