// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/exponentials.hpp"

#include <map>

#include "generator/graph/replaced.hpp"
#include "generator/lower/kernel.hpp"

namespace hvi::gen {

namespace {

/// Returns the argument of an exponential, its number apart.
Scaled exponent_of(const Graph& graph, const Computation& exponential) {
    const Node argument = exponential.arguments.front();
    const std::vector<Scaled>& terms = graph.at(argument).terms;
    return terms.size() == 1 ? terms.front() : Scaled{{1, 1}, argument};
}

}  // namespace

std::vector<Scaled> with_powers_of_exponentials(Graph& graph, const std::vector<Scaled>& values) {
    constexpr long highest = 8;
    // Exponentials by the node and the sign of the exponent, the smallest number first.
    std::map<std::pair<Node, bool>, std::map<double, std::pair<SmallFraction, Node>>> exponentials;
    for (const Node node : kernel(graph, values).nodes) {
        const Computation& computation = graph.at(node);
        if (computation.operation != Operation::call || computation.name != "exp") { continue; }
        const auto [factor, of] = exponent_of(graph, computation);
        const double size =
            static_cast<double>(factor.size().above) / static_cast<double>(factor.below);
        exponentials[{of, factor.above < 0}].emplace(size, std::pair(factor, node));
    }
    std::map<Node, Scaled> forms;
    for (const auto& [of, by_size] : exponentials) {
        const auto& [least, base] = by_size.begin()->second;
        for (const auto& [size, exponential] : by_size) {
            const auto& [factor, node] = exponential;
            const auto times =
                SmallFraction::of(factor.above * least.below, factor.below * least.above);
            if (node == base || !times || times->below != 1 || times->above > highest) { continue; }
            forms[node] = graph.half_power({{1, 1}, base}, 2 * times->above);
        }
    }
    return forms.empty() ? values : rewritten(graph, values, forms);
}

}  // namespace hvi::gen
