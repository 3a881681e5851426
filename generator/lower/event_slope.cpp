// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/event_slope.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "generator/lower/derivative.hpp"

namespace hvi::gen {

namespace {

/// Returns g - w dL/dv, whose derivatives by q and t are those of g at constant p. Sets the
/// derivatives of g by velocities, and those by momenta, which are w.
Scaled at_constant_momenta(LoweredEvents& events, LoweredEvent& event) {
    const LoweredVelocities& solved = *events.velocities;
    Graph& graph = events.graph;
    event.by_velocities = gradient(graph, event.zero, solved.velocities);
    const bool depends = std::any_of(event.by_velocities.begin(), event.by_velocities.end(),
                                     [](const Scaled& slope) { return !slope.is_zero(); });
    if (!depends) {
        event.by_velocities.clear();
        return event.zero;
    }
    std::vector<Scaled> terms{event.zero};
    for (std::size_t i = 0; i < solved.weights.size(); ++i) {
        const Scaled weight{{1, 1}, solved.weights[i]};
        terms.push_back(graph.times({-1, 1}, graph.product(weight, solved.momenta[i])));
        event.by_variables.push_back({events.degrees + i, weight});
    }
    return graph.sum(std::move(terms));
}

}  // namespace

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

EventMotion motion_under(LoweredEvents& events, const Scaled& hamiltonian,
                         const std::vector<std::size_t>& numbers) {
    std::map<std::size_t, Node> nodes;
    for (const EventVariable& each : events.variables) { nodes[each.number] = each.node; }
    EventMotion motion;
    std::vector<std::size_t> moved;
    std::vector<Node> conjugates;
    for (const std::size_t number : numbers) {
        const bool is_coordinate = number < events.degrees;
        const auto conjugate =
            nodes.find(is_coordinate ? number + events.degrees : number - events.degrees);
        if (conjugate == nodes.end()) {
            motion[number] = Graph::number(0);
            continue;
        }
        moved.push_back(number);
        conjugates.push_back(conjugate->second);
    }
    const std::vector<Scaled> slopes = gradient(events.graph, hamiltonian, conjugates);
    for (std::size_t k = 0; k < moved.size(); ++k) {
        const long sign = moved[k] < events.degrees ? 1 : -1;
        motion[moved[k]] = events.graph.times({sign, 1}, slopes[k]);
    }
    return motion;
}

void differentiate(LoweredEvents& events, LoweredEvent& event) {
    Graph& graph = events.graph;
    const Scaled g = events.velocities ? at_constant_momenta(events, event) : event.zero;
    const std::vector<bool> is_part = nodes_of(graph, {g});
    std::vector<std::size_t> numbers;
    std::vector<Node> inputs;
    for (const EventVariable& each : events.variables) {
        if (!is_part[each.node]) { continue; }
        numbers.push_back(each.number);
        inputs.push_back(each.node);
    }
    if (events.time) { inputs.push_back(*events.time); }
    const std::vector<Scaled> slopes = gradient(graph, g, inputs);
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        event.by_variables.push_back({numbers[k], slopes[k]});
    }
    if (events.time) { event.by_time = slopes.back(); }
    std::vector<Scaled> terms{event.by_time};
    for (const auto& [number, slope] : event.by_variables) {
        terms.push_back(graph.product(slope, events.motion.at(number)));
    }
    event.slope = graph.sum(std::move(terms));
}

}  // namespace hvi::gen
