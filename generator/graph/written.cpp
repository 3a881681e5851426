// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/graph/written.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "generator/expr/places.hpp"

namespace hvi::gen {

namespace {

constexpr std::size_t most_words = 2000;

/// Counts the words of nodes, each node once.
class Words {
public:
    explicit Words(const Graph& graph) : graph_(graph) {}

    [[nodiscard]] std::size_t of(Node node) {
        const auto known = counts_.find(node);
        if (known != counts_.end()) { return known->second; }
        const Computation& computation = graph_.at(node);
        std::size_t count = 1;
        for (const Scaled& term : computation.terms) { count += of(term.node); }
        for (const Node argument : computation.arguments) { count += of(argument); }
        return counts_[node] = std::min(count, most_words + 1);
    }

private:
    const Graph& graph_;
    std::map<Node, std::size_t> counts_;
};

Expression whole(const Graph& graph, const Scaled& a) {
    const Computation& computation = graph.at(a.node);
    if (a.factor.above < 0) { return Expression::negation(whole(graph, {-a.factor, a.node})); }
    if (graph.is_number(a)) { return as_expression(a.factor); }
    if (!a.factor.is_one()) {
        return Expression::product({as_expression(a.factor), whole(graph, {{1, 1}, a.node})});
    }
    if (computation.operation == Operation::constant) {
        return without_places(computation.constant);
    }
    if (computation.operation == Operation::input) { return Expression::symbol(computation.name); }
    std::vector<Expression> values;
    for (const Scaled& term : computation.terms) { values.push_back(whole(graph, term)); }
    for (const Node argument : computation.arguments) {
        values.push_back(whole(graph, {{1, 1}, argument}));
    }
    return of_operation(computation, std::move(values));
}

}  // namespace

Expression as_expression(const SmallFraction& fraction) {
    const SmallFraction size = fraction.size();
    Expression result =
        Expression::rational(std::to_string(size.above), std::to_string(size.below));
    return fraction.above < 0 ? Expression::negation(std::move(result)) : result;
}

Expression of_operation(const Computation& computation, std::vector<Expression> values) {
    const auto first = [&] { return std::move(values.front()); };
    const auto root = [&] { return Expression::call("sqrt", {first()}); };
    switch (computation.operation) {
    case Operation::sum: return Expression::sum(std::move(values));
    case Operation::product: return Expression::product(std::move(values));
    case Operation::inverse: return Expression::reciprocal(first());
    case Operation::square_root: return root();
    case Operation::inverse_square_root: return Expression::reciprocal(root());
    case Operation::power:
        return Expression::power(std::move(values.front()), std::move(values.back()));
    case Operation::call: return Expression::call(computation.name, std::move(values));
    case Operation::constant:
    case Operation::input: break;
    }
    HVI_CHECK(false);
    return {};
}

std::optional<Expression> written(const Graph& graph, const Scaled& a) {
    if (Words(graph).of(a.node) > most_words) { return std::nullopt; }
    return whole(graph, a);
}

}  // namespace hvi::gen
