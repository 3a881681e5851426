// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/kernel.hpp"

#include <utility>

namespace hvi::gen {

namespace {

void count_factor(OperationCounts& counts, const SmallFraction& factor) {
    if (!factor.size().is_one()) { ++counts.multiplications; }
}

void count(OperationCounts& counts, const Computation& computation) {
    switch (computation.operation) {
    case Operation::constant:
    case Operation::input: break;
    case Operation::sum:
        counts.additions += computation.terms.size() - 1;
        for (const Scaled& term : computation.terms) { count_factor(counts, term.factor); }
        break;
    case Operation::product: ++counts.multiplications; break;
    case Operation::inverse: ++counts.divisions; break;
    case Operation::inverse_square_root: ++counts.divisions; [[fallthrough]];
    case Operation::square_root: ++counts.square_roots; break;
    case Operation::power:
    case Operation::call: ++counts.calls; break;
    }
}

bool varies(const Computation& computation) {
    return (computation.roles & ~static_cast<unsigned>(Role::parameter)) != 0;
}

}  // namespace

Kernel kernel(const Graph& graph, std::vector<Scaled> results) {
    Kernel kernel;
    kernel.uses.resize(graph.size());
    for (const Scaled& result : results) {
        ++kernel.uses[result.node];
        count_factor(kernel.per_evaluation, result.factor);
    }
    for (auto node = static_cast<Node>(graph.size()); node-- > 0;) {
        if (kernel.uses[node] == 0) { continue; }
        const Computation& computation = graph.at(node);
        // NOTE: what is computed once may be needed by it, but is not needed at each evaluation.
        for (const Scaled& term : computation.terms) { ++kernel.uses[term.node]; }
        for (const Node argument : computation.arguments) { ++kernel.uses[argument]; }
    }
    for (Node node = 0; node < graph.size(); ++node) {
        const Computation& computation = graph.at(node);
        if (kernel.uses[node] == 0 || computation.operation == Operation::input) { continue; }
        (varies(computation) ? kernel.each : kernel.once).push_back(node);
        if (varies(computation)) { count(kernel.per_evaluation, computation); }
    }
    kernel.results = std::move(results);
    return kernel;
}

}  // namespace hvi::gen
