// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/event_slope.hpp"

#include <map>
#include <utility>

#include "generator/lower/derivative.hpp"

namespace hvi::gen {

std::vector<bool> nodes_of(const Graph& graph, const std::vector<Scaled>& values) {
    std::vector<bool> is_part(graph.size());
    for (const Scaled& value : values) { is_part[value.node] = true; }
    for (Node node = static_cast<Node>(graph.size()); node-- > 0;) {
        if (!is_part[node]) { continue; }
        for (const Scaled& term : graph.at(node).terms) { is_part[term.node] = true; }
        for (const Node argument : graph.at(node).arguments) { is_part[argument] = true; }
    }
    return is_part;
}

Scaled slope_along(LoweredEvents& events, const Scaled& g, const Scaled& hamiltonian,
                   std::size_t degrees) {
    Graph& graph = events.graph;
    const std::vector<bool> is_part = nodes_of(graph, {g});
    std::map<std::size_t, Node> nodes;
    for (const EventVariable& each : events.variables) { nodes[each.number] = each.node; }
    // Variables that g depends on, and their partners in H.
    std::vector<Node> own, partners;
    std::vector<long> signs;
    for (const auto& [number, node] : nodes) {
        const bool is_coordinate = number < degrees;
        const auto partner = nodes.find(is_coordinate ? number + degrees : number - degrees);
        if (!is_part[node] || partner == nodes.end()) { continue; }
        own.push_back(node);
        partners.push_back(partner->second);
        signs.push_back(is_coordinate ? 1 : -1);
    }
    if (events.time && is_part[*events.time]) { own.push_back(*events.time); }
    const std::vector<Scaled> by_own = gradient(graph, g, own),
                              by_partners = gradient(graph, hamiltonian, partners);
    std::vector<Scaled> terms;
    for (std::size_t k = 0; k < partners.size(); ++k) {
        terms.push_back(graph.times({signs[k], 1}, graph.product(by_own[k], by_partners[k])));
    }
    if (own.size() > partners.size()) { terms.push_back(by_own.back()); }
    return graph.sum(std::move(terms));
}

}  // namespace hvi::gen
