// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/graph/polynomial.hpp"

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <optional>
#include <utility>

namespace hvi::gen {

namespace {

constexpr std::size_t most_monomials = 24;
constexpr long highest_power = 64;

NodePolynomial power(Node node, long twice_exponent) {
    return {{{{node, twice_exponent}}, Graph::number(1)}};
}

PowerProduct product(const PowerProduct& a, const PowerProduct& b) {
    std::map<Node, long> exponents(a.begin(), a.end());
    for (const auto& [node, twice_exponent] : b) { exponents[node] += twice_exponent; }
    std::erase_if(exponents, [](const auto& factor) { return factor.second == 0; });
    return {exponents.begin(), exponents.end()};
}

bool is_short(const NodePolynomial& polynomial) {
    return polynomial.size() <= most_monomials &&
           std::all_of(polynomial.begin(), polynomial.end(), [](const auto& term) {
               return std::all_of(term.first.begin(), term.first.end(), [](const auto& factor) {
                   return std::labs(factor.second) <= 2 * highest_power;
               });
           });
}

void add(Graph& graph, NodePolynomial& polynomial, const PowerProduct& monomial,
         const Scaled& coefficient) {
    if (coefficient.is_zero()) { return; }
    const auto [found, is_new] = polynomial.emplace(monomial, coefficient);
    if (is_new) { return; }
    found->second = graph.sum({found->second, coefficient});
    if (found->second.is_zero()) { polynomial.erase(found); }
}

long twice_exponent_of(Node node, const PowerProduct& monomial) {
    const auto found = std::find_if(monomial.begin(), monomial.end(),
                                    [&](const auto& factor) { return factor.first == node; });
    return found == monomial.end() ? 0 : found->second;
}

/// Returns the variables of which there is a square or a higher power, and whole powers alone.
std::vector<Node> with_whole_powers(const NodePolynomial& polynomial) {
    std::map<Node, std::pair<bool, long>> found;
    for (const auto& [monomial, coefficient] : polynomial) {
        for (const auto& [node, twice_exponent] : monomial) {
            auto& [is_whole, most] = found.emplace(node, std::pair(true, 0L)).first->second;
            is_whole = is_whole && twice_exponent > 0 && twice_exponent % 2 == 0;
            most = std::max(most, twice_exponent);
        }
    }
    std::vector<Node> result;
    for (const auto& [node, powers] : found) {
        if (powers.first && powers.second >= 4) { result.push_back(node); }
    }
    return result;
}

/// Divides by the node less b, by Horner's scheme. Returns nothing where a remainder is left.
std::optional<NodePolynomial> divided(Graph& graph, const NodePolynomial& polynomial, Node node,
                                      const Scaled& b) {
    std::map<long, NodePolynomial, std::greater<>> by_powers;
    for (const auto& [monomial, coefficient] : polynomial) {
        const long twice = twice_exponent_of(node, monomial);
        by_powers[twice / 2].emplace(product(monomial, {{node, -twice}}), coefficient);
    }
    NodePolynomial quotient, last;
    for (long power = by_powers.begin()->first; power >= 0; --power) {
        NodePolynomial next = by_powers[power];
        for (const auto& [monomial, coefficient] : last) {
            add(graph, next, product(monomial, {{b.node, 2}}), graph.times(b.factor, coefficient));
        }
        last = std::move(next);
        if (power == 0) { break; }
        for (const auto& [monomial, coefficient] : last) {
            const PowerProduct of_node =
                power == 1 ? PowerProduct{} : PowerProduct{{node, 2 * (power - 1)}};
            add(graph, quotient, product(monomial, of_node), coefficient);
        }
    }
    return last.empty() ? std::optional(std::move(quotient)) : std::nullopt;
}

}  // namespace

NodePolynomial Expansion::operator()(const Scaled& value) {
    NodePolynomial result;
    for (const auto& [monomial, coefficient] : opened(value.node)) {
        add(result, monomial, graph_.times(value.factor, coefficient));
    }
    return result;
}

const NodePolynomial& Expansion::at(Node node) {
    const auto found = known_.find(node);
    if (found != known_.end()) { return found->second; }
    NodePolynomial result = stays_whole(node) ? power(node, 2) : opened(node);
    return known_.emplace(node, std::move(result)).first->second;
}

NodePolynomial Expansion::opened(Node node) {
    // NOTE: a copy, since the graph grows.
    const Computation computation = graph_.at(node);
    const std::vector<Node>& arguments = computation.arguments;
    if (!varies(computation.roles)) {
        const bool is_multiple = computation.terms.size() == 1;
        return {{{}, is_multiple ? computation.terms.front() : Scaled{{1, 1}, node}}};
    }
    const auto half = graph_.half_power_at(node);
    if (half && half->base.factor.is_one()) { return power(half->base.node, half->twice_exponent); }
    NodePolynomial result;
    switch (computation.operation) {
    case Operation::sum: result = sum(computation.terms); break;
    case Operation::product: result = product(at(arguments[0]), at(arguments[1])); break;
    case Operation::inverse: return inverse(arguments[0]);
    case Operation::square_root: return power(arguments[0], 1);
    case Operation::inverse_square_root: return power(arguments[0], -1);
    default: return power(node, 2);
    }
    return is_short(result) ? result : power(node, 2);
}

NodePolynomial Expansion::sum(const std::vector<Scaled>& terms) {
    NodePolynomial result;
    for (const Scaled& term : terms) {
        for (const auto& [monomial, coefficient] : at(term.node)) {
            add(result, monomial, graph_.times(term.factor, coefficient));
        }
        if (!is_short(result)) { break; }
    }
    return result;
}

NodePolynomial Expansion::product(const NodePolynomial& a, const NodePolynomial& b) {
    NodePolynomial result;
    for (const auto& [of_a, by_a] : a) {
        for (const auto& [of_b, by_b] : b) {
            add(result, gen::product(of_a, of_b), graph_.product(by_a, by_b));
        }
        if (!is_short(result)) { break; }
    }
    return result;
}

NodePolynomial Expansion::inverse(Node node) {
    const NodePolynomial& divisor = at(node);
    if (divisor.size() > 1 || divisor.begin()->first.empty()) { return power(node, -2); }
    PowerProduct powers = divisor.begin()->first;
    for (auto& [factor, twice_exponent] : powers) { twice_exponent *= -1; }
    return {{std::move(powers), graph_.inverse(divisor.begin()->second)}};
}

bool Expansion::stays_whole(Node node) const {
    const Computation& computation = graph_.at(node);
    const std::vector<Scaled>& terms = computation.terms;
    if (!varies(computation.roles)) { return false; }
    if (is_whole_(node)) { return true; }
    return !terms.empty() && std::all_of(terms.begin(), terms.end(), [&](const Scaled& term) {
        return graph_.at(term.node).operation == Operation::input;
    });
}

void Expansion::add(NodePolynomial& polynomial, const PowerProduct& monomial,
                    const Scaled& coefficient) {
    gen::add(graph_, polynomial, monomial, coefficient);
}

std::vector<LinearFactor> linear_factors(Graph& graph, const NodePolynomial& polynomial) {
    constexpr std::size_t most_variables = 4;
    const std::vector<Node> variables = with_whole_powers(polynomial);
    std::vector<LinearFactor> result;
    if (variables.size() > most_variables) { return result; }
    for (std::size_t i = 0; i < variables.size(); ++i) {
        for (std::size_t k = i + 1; k < variables.size(); ++k) {
            const Node a = variables[i], b = variables[k];
            for (const long sign : {1L, -1L}) {
                auto quotient = divided(graph, polynomial, a, {{sign, 1}, b});
                if (!quotient) { continue; }
                const Scaled factor = graph.sum({{{1, 1}, a}, {{-sign, 1}, b}});
                result.push_back({factor, std::move(*quotient)});
            }
        }
    }
    return result;
}

}  // namespace hvi::gen
