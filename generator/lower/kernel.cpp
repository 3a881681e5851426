// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/kernel.hpp"

#include <algorithm>
#include <utility>

namespace hvi::gen {

namespace {

void count_factor(OperationCounts& counts, const SmallFraction& factor) {
    if (!factor.size().is_one()) { ++counts.multiplications; }
}

void count(const Graph& graph, Kernel& kernel, Node node) {
    OperationCounts& counts = kernel.counts;
    const Computation& computation = graph.at(node);
    switch (computation.operation) {
    case Operation::constant:
    case Operation::input: break;
    case Operation::sum:
        counts.additions += computation.terms.size() - 1;
        for (const Scaled& term : computation.terms) { count_factor(counts, term.factor); }
        break;
    case Operation::product:
        if (std::none_of(computation.arguments.begin(), computation.arguments.end(),
                         [&](Node argument) { return is_divisor(graph, kernel, argument); })) {
            ++counts.multiplications;
        }
        break;
    case Operation::inverse: ++counts.divisions; break;
    case Operation::inverse_square_root: ++counts.divisions; [[fallthrough]];
    case Operation::square_root: ++counts.square_roots; break;
    case Operation::power:
    case Operation::call: ++counts.calls; break;
    }
}

template <class IsGiven>
Kernel kernel(const Graph& graph, std::vector<Scaled> results, IsGiven is_given) {
    Kernel kernel;
    kernel.uses.resize(graph.size());
    for (const Scaled& result : results) { ++kernel.uses[result.node]; }
    for (auto node = static_cast<Node>(graph.size()); node-- > 0;) {
        if (kernel.uses[node] == 0) { continue; }
        const Computation& computation = graph.at(node);
        if (is_given(computation)) {
            kernel.given.push_back(node);
            continue;
        }
        kernel.nodes.push_back(node);
        for (const Scaled& term : computation.terms) { ++kernel.uses[term.node]; }
        for (const Node argument : computation.arguments) { ++kernel.uses[argument]; }
    }
    std::reverse(kernel.given.begin(), kernel.given.end());
    std::reverse(kernel.nodes.begin(), kernel.nodes.end());
    for (const Node node : kernel.nodes) { count(graph, kernel, node); }
    for (const Scaled& result : results) {
        if (!graph.is_number(result)) { count_factor(kernel.counts, result.factor); }
    }
    kernel.results = std::move(results);
    return kernel;
}

}  // namespace

Kernel kernel(const Graph& graph, std::vector<Scaled> results) {
    return kernel(graph, std::move(results), [](const Computation& computation) {
        return computation.operation == Operation::input || !varies(computation.roles);
    });
}

Kernel kernel_of_inputs(const Graph& graph, std::vector<Scaled> results) {
    return kernel(graph, std::move(results), [](const Computation& computation) {
        return computation.operation == Operation::input ||
               computation.operation == Operation::constant;
    });
}

Kernel kernel_of_direction(const Graph& graph, std::vector<Scaled> results) {
    return kernel(graph, std::move(results), [](const Computation& computation) {
        return computation.operation == Operation::input ||
               !has(computation.roles, Role::direction);
    });
}

bool is_divisor(const Graph& graph, const Kernel& kernel, Node node) {
    const Operation operation = graph.at(node).operation;
    const bool is_inverse =
        operation == Operation::inverse || operation == Operation::inverse_square_root;
    return is_inverse && kernel.uses[node] == 1 &&
           std::binary_search(kernel.nodes.begin(), kernel.nodes.end(), node);
}

}  // namespace hvi::gen
