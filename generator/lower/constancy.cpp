// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/constancy.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "generator/exact/expressions/evaluate.hpp"
#include "generator/exact/numbers/rational.hpp"
#include "generator/graph/written.hpp"
#include "generator/scene/value_at.hpp"

namespace hvi::gen {

namespace {

/// Values of nodes where all variables are 0, in the same graph.
class AtOrigin {
public:
    explicit AtOrigin(Graph& graph) : graph_(graph) {}

    /// Returns the value; empty where it divides by zero.
    [[nodiscard]] std::optional<Scaled> operator()(const Scaled& a) {
        const auto value = at(a.node);
        return value ? std::optional(graph_.times(a.factor, *value)) : std::nullopt;
    }

private:
    [[nodiscard]] std::optional<Scaled> at(Node node) {
        // NOTE: a copy, since the graph grows.
        const Computation computation = graph_.at(node);
        if (!varies(computation.roles)) { return Scaled{{1, 1}, node}; }
        if (computation.operation == Operation::input) { return Graph::number(0); }
        std::vector<Scaled> arguments;
        for (const Scaled& term : computation.terms) {
            const auto value = (*this)(term);
            if (!value) { return std::nullopt; }
            arguments.push_back(*value);
        }
        for (const Node argument : computation.arguments) {
            const auto value = at(argument);
            if (!value) { return std::nullopt; }
            arguments.push_back(*value);
        }
        return made_of(computation, arguments);
    }

    [[nodiscard]] std::optional<Scaled> made_of(const Computation& computation,
                                                const std::vector<Scaled>& arguments) {
        switch (computation.operation) {
        case Operation::sum: return graph_.sum(arguments);
        case Operation::product: return graph_.product(arguments[0], arguments[1]);
        case Operation::square_root: return graph_.half_power(arguments[0], 1);
        case Operation::power: return graph_.power(arguments[0], arguments[1]);
        case Operation::call: return graph_.call(computation.name, arguments);
        default: break;
        }
        if (arguments[0].is_zero()) { return std::nullopt; }
        return graph_.half_power(arguments[0],
                                 computation.operation == Operation::inverse ? -2 : -1);
    }

    Graph& graph_;
};

/// Returns whether an expression has one value at two points. NOTE: the test only saves work, and
/// refusing is always right: a proof that an expression is constant can take long, and is not tried
/// where the values differ.
bool seems_constant(const Graph& graph, const Expression& expression) {
    try {
        const Ball first = value_at(expression, sample_point(graph, 0), nullptr);
        const Ball second = value_at(expression, sample_point(graph, 1), nullptr);
        return arb_is_finite(first.get()) != 0 && arb_overlaps(first.get(), second.get()) != 0;
    } catch (const MathError&) { return false; }
}

/// Returns whether an expression may be 0 at a point: as above, the test only saves work.
bool seems_zero(const Graph& graph, const Expression& expression) {
    try {
        const Ball value = value_at(expression, sample_point(graph, 0), nullptr);
        return arb_contains_zero(value.get()) != 0;
    } catch (const MathError&) { return false; }
}

}  // namespace

SymbolValues sample_point(const Graph& graph, std::size_t step) {
    SymbolValues values;
    for (Node node = 0; node < graph.size(); ++node) {
        const Computation& computation = graph.at(node);
        if (computation.operation != Operation::input) { continue; }
        const std::size_t above = node + (varies(computation.roles) ? 31 + 7 * step : 53);
        values[computation.name] = ball_of_rational(
            std::to_string(above) + "/" + std::to_string(97 + 2 * node), first_precision);
    }
    return values;
}

std::optional<Scaled> at_origin(Graph& graph, const Scaled& a) { return AtOrigin(graph)(a); }

std::optional<Scaled> constant_value(Graph& graph, const Scaled& a) {
    if (!varies(graph.at(a.node).roles)) { return a; }
    const auto varying = written(graph, a);
    if (!varying || !seems_constant(graph, *varying)) { return std::nullopt; }
    const auto value = at_origin(graph, a);
    const auto constant = value ? written(graph, *value) : std::nullopt;
    if (!constant) { return std::nullopt; }
    const Expression difference = Expression::sum({*varying, Expression::negation(*constant)});
    return is_proved_zero(difference) ? value : std::nullopt;
}

bool depend(const Graph& graph, const std::vector<Scaled>& values, const std::vector<Node>& nodes) {
    std::set<Node> open;
    for (const Scaled& value : values) {
        if (!value.is_zero()) { open.insert(value.node); }
    }
    while (!open.empty()) {
        const Node node = *open.rbegin();
        open.erase(node);
        if (std::find(nodes.begin(), nodes.end(), node) != nodes.end()) { return true; }
        const Computation& computation = graph.at(node);
        if ((computation.roles & of_state) == 0) { continue; }
        for (const Scaled& term : computation.terms) { open.insert(term.node); }
        for (const Node argument : computation.arguments) { open.insert(argument); }
    }
    return false;
}

Scaled difference_of(Graph& graph, const Scaled& a, const Scaled& b) {
    return graph.sum({a, graph.times({-1, 1}, b)});
}

bool is_proved_zero(const Graph& graph, const Scaled& a) {
    if (a.is_zero()) { return true; }
    const auto expression = written(graph, a);
    return expression && seems_zero(graph, *expression) && is_proved_zero(*expression);
}

}  // namespace hvi::gen
