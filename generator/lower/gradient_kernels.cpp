// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/gradient_kernels.hpp"

#include <utility>

namespace hvi::gen {

GradientKernels gradient_kernels(const System& system) {
    const std::vector<Scaled> by_q = by_coordinates(system), by_y = by_conjugates(system);
    std::vector<Scaled> both = by_q;
    both.insert(both.end(), by_y.begin(), by_y.end());
    GradientKernels result;
    result.by_q = kernel(system.graph, by_q);
    result.by_conjugates = kernel(system.graph, by_y);
    result.joint = kernel(system.graph, std::move(both));
    result.by_conjugates_at_q = kernel_of_momenta(system.graph, by_y);
    result.shared = computed_before(system.graph, result.by_conjugates_at_q);
    return result;
}

std::vector<Node> computed_before(const Graph& graph, const Kernel& kernel) {
    std::vector<Node> result;
    for (const Node node : kernel.given) {
        const Computation& computation = graph.at(node);
        if (computation.operation != Operation::input && varies(computation.roles)) {
            result.push_back(node);
        }
    }
    return result;
}

EvaluationCosts evaluation_costs(const System& system, const GradientKernels& kernels) {
    std::vector<Scaled> second;
    const auto& [qq, mixed, conjugates] = hessian_of(system);
    for (const HessianBlock* block : {&qq, &mixed, &conjugates}) {
        for (const std::vector<Scaled>& row : *block) {
            second.insert(second.end(), row.begin(), row.end());
        }
    }
    return {
        .by_q = cost(kernels.by_q.counts),
        .by_p_at_q = cost(kernels.by_conjugates_at_q.counts),
        .joint = cost(kernels.joint.counts),
        .second = cost(kernel(system.graph, std::move(second)).counts),
        .has_calls = kernels.joint.counts.calls > 0,
    };
}

}  // namespace hvi::gen
