// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/plan/evaluations.hpp"

#include <algorithm>
#include <utility>

namespace hvi::gen {

namespace {

BlockKernel block(const Graph& graph, const HessianBlock& entries, bool is_symmetric) {
    BlockKernel result;
    result.is_symmetric = is_symmetric;
    std::vector<Scaled> values;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        for (std::size_t j = 0; j < (is_symmetric ? i + 1 : entries.size()); ++j) {
            if (entries[i][j].is_zero()) { continue; }
            result.places.push_back({i, j});
            values.push_back(entries[i][j]);
        }
    }
    result.kernel = kernel(graph, std::move(values));
    return result;
}

/// Returns the blocks for Newton's method, or their constant terms.
SecondDerivatives blocks(const System& system, const Hessian& hessian, const Step& step) {
    const Graph& graph = system.graph;
    SecondDerivatives result;
    result.qq = block(graph, hessian.qq, rotations_of(system) == 0);
    if (std::holds_alternative<VelocityStep>(step.form)) { return result; }
    result.conjugates = block(graph, hessian.conjugates, true);
    if (!step.is_separable()) { result.mixed = block(graph, hessian.mixed, false); }
    return result;
}

SecondDerivatives second_derivatives(const System& system, const Step& step) {
    if (step.iteration()->takes_newton()) { return blocks(system, hessian_of(system), step); }
    SecondDerivatives result;
    result.conjugates = block(system.graph, hessian_of(system).conjugates, true);
    return result;
}

void add_linear_part(Evaluations& evaluations, const System& system, const Step& step) {
    if (const auto* all = std::get_if<Hessian>(&system.structure.constant)) {
        evaluations.constant = blocks(system, *all, step);
        return;
    }
    std::vector<Scaled> values;
    for (const LinearStiffness& linear :
         std::get<std::vector<LinearStiffness>>(system.structure.constant)) {
        values.push_back(linear.value);
    }
    evaluations.stiffness = kernel(system.graph, std::move(values));
}

/// Returns a kernel of dH/dq, followed by these nodes.
Kernel force_and(const System& system, const std::vector<Node>& kept) {
    std::vector<Scaled> values = by_coordinates(system);
    for (const Node node : kept) { values.push_back({{1, 1}, node}); }
    return kernel(system.graph, std::move(values));
}

Tangents tangents(const System& system) {
    Tangents result{kernel_of_direction(system.graph, system.structure.qq_along), {}, {}};
    result.kept = computed_before(system.graph, result.along);
    result.slope = force_and(system, result.kept);
    return result;
}

}  // namespace

OperationCounts SecondDerivatives::counts() const {
    OperationCounts sum;
    for (const std::optional<BlockKernel>* block : {&qq, &mixed, &conjugates}) {
        if (*block) { sum += (*block)->kernel.counts; }
    }
    return sum;
}

Evaluations evaluations(const System& system, GradientKernels gradients, const Step& step) {
    Evaluations result;
    result.gradients = std::move(gradients);
    if (std::holds_alternative<VelocityStep>(step.form)) {
        result.inverse_mass = kernel(system.graph, system.structure.inverse_mass);
    }
    if (step.shared_slopes > 0) { result.shared = force_and(system, result.gradients.shared); }
    if (step.corrections && exists(step.corrections->linear)) {
        add_linear_part(result, system, step);
    }
    const Iteration* iteration = step.iteration();
    if (iteration == nullptr) { return result; }
    if (iteration->takes_newton() || std::holds_alternative<GalerkinStep>(step.form)) {
        result.second = second_derivatives(system, step);
    }
    if (iteration->solver == Solver::newton_taylor) { result.tangents = tangents(system); }
    return result;
}

}  // namespace hvi::gen
