// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/graph/pythagoras.hpp"

#include <algorithm>
#include <optional>

namespace hvi::gen {

namespace {

/// Limit on the factors of a product. Longer products are high powers, and are left alone.
constexpr std::size_t most_factors = 16;

/// A term as factor * function(argument)^2 * rest.
struct Square {
    SmallFraction factor;
    std::string function;
    Node argument;
    std::vector<Node> rest;  ///< ascending
};

/// Adds the factors of a node. Returns false where there are too many.
bool add_factors(const Graph& graph, Node node, std::vector<Node>& factors) {
    const Computation& computation = graph.at(node);
    if (computation.operation != Operation::product) {
        factors.push_back(node);
        return factors.size() <= most_factors;
    }
    return std::all_of(computation.arguments.begin(), computation.arguments.end(),
                       [&](Node argument) { return add_factors(graph, argument, factors); });
}

bool is_of_pair(const std::string& function) {
    return function == "sin" || function == "cos" || function == "sinh" || function == "cosh";
}

std::vector<Square> squares(const Graph& graph, const Scaled& term) {
    std::vector<Node> factors;
    if (!add_factors(graph, term.node, factors)) { return {}; }
    std::sort(factors.begin(), factors.end());
    std::vector<Square> result;
    for (std::size_t i = 0; i + 1 < factors.size(); ++i) {
        const Computation& computation = graph.at(factors[i]);
        const bool is_first = i == 0 || factors[i - 1] != factors[i];
        if (!is_first || factors[i] != factors[i + 1] || !is_of_pair(computation.name)) {
            continue;
        }
        std::vector<Node> rest = factors;
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i),
                   rest.begin() + static_cast<std::ptrdiff_t>(i) + 2);
        result.push_back({term.factor, computation.name, computation.arguments.front(), rest});
    }
    return result;
}

/// Returns the factor of the sum of both terms; empty where no identity applies to them.
std::optional<SmallFraction> together(const Square& a, const Square& b) {
    if (a.argument != b.argument || a.rest != b.rest) { return std::nullopt; }
    if (a.function == "sin" && b.function == "cos" && a.factor == b.factor) { return a.factor; }
    if (a.function == "cosh" && b.function == "sinh" && a.factor == -b.factor) { return a.factor; }
    return std::nullopt;
}

Scaled product(Graph& graph, const SmallFraction& factor, const std::vector<Node>& nodes) {
    Scaled result = Graph::number(factor);
    for (const Node node : nodes) { result = graph.product(result, {{1, 1}, node}); }
    return result;
}

/// Replaces one pair of terms. Returns whether there was one.
bool apply_once(Graph& graph, std::vector<Scaled>& terms) {
    std::vector<std::vector<Square>> all;
    for (const Scaled& term : terms) { all.push_back(squares(graph, term)); }
    for (std::size_t i = 0; i < terms.size(); ++i) {
        for (std::size_t j = 0; j < terms.size(); ++j) {
            for (const Square& a : all[i]) {
                for (const Square& b : all[j]) {
                    const auto factor = together(a, b);
                    if (!factor) { continue; }
                    terms[std::min(i, j)] = product(graph, *factor, a.rest);
                    terms.erase(terms.begin() + static_cast<std::ptrdiff_t>(std::max(i, j)));
                    return true;
                }
            }
        }
    }
    return false;
}

}  // namespace

bool apply_pythagoras(Graph& graph, std::vector<Scaled>& terms) {
    return terms.size() > 1 && apply_once(graph, terms);
}

}  // namespace hvi::gen
