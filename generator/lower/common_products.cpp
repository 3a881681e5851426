// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/common_products.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "generator/graph/replaced.hpp"
#include "generator/lower/kernel.hpp"

namespace hvi::gen {

namespace {

/// Factors of a product, each with its exponent.
using Factors = std::map<Node, long>;
using Pair = std::pair<Node, Node>;

constexpr long most_factors = 32;

/// Whether what does not vary in a product is one factor of it, or several. NOTE: a v y f with a y
/// elsewhere and v f elsewhere has fewer operations with a and v apart, and a b x with a c x with a
/// b and a c together.
enum class Constants { together, apart };

class CommonProducts {
public:
    CommonProducts(Graph& graph, const std::vector<Scaled>& values, Constants constants)
        : graph_(graph), constants_(constants) {
        const Kernel before = kernel(graph, values);
        std::vector<bool> is_whole(graph.size());
        for (const Scaled& value : values) { is_whole[value.node] = true; }
        for (const Node node : before.nodes) {
            const Computation& computation = graph.at(node);
            for (const Scaled& term : computation.terms) { is_whole[term.node] = true; }
            if (is_product(node)) { continue; }
            for (const Node argument : computation.arguments) { is_whole[argument] = true; }
        }
        for (const Node node : before.nodes) {
            if (is_whole[node] && is_product(node)) { products_[node] = factors_of(node); }
        }
    }

    /// Returns other forms of products.
    [[nodiscard]] std::map<Node, Scaled> operator()() && {
        for (const auto& [product, factors] : products_) {
            for (const auto& [node, exponent] : factors) { users_[node].insert(product); }
            count_pairs(factors, 1);
        }
        while (!ranks_.empty()) { take_out(ranks_.begin()->second); }
        std::map<Node, Scaled> forms;
        for (const auto& [product, factors] : products_) {
            const Scaled form = multiplied(factors);
            if (form.node != product) { forms[product] = form; }
        }
        return forms;
    }

private:
    /// NOTE: a power a^(n/2) is one factor, as the graph knows its derivative.
    [[nodiscard]] bool is_product(Node node) const {
        return graph_.at(node).operation == Operation::product && !graph_.half_power_at(node);
    }

    /// Returns the factors.
    [[nodiscard]] Factors factors_of(Node product) {
        Factors factors;
        long left = most_factors;
        add_factors(product, factors, left);
        if (left < 0) { return {{product, 1}}; }
        if (constants_ == Constants::together) { put_constants_together(factors); }
        return factors;
    }

    void put_constants_together(Factors& factors) {
        Scaled constant = Graph::number(1);
        for (const auto& [node, exponent] : factors) {
            if (varies(graph_.at(node).roles)) { continue; }
            constant = graph_.product(constant, graph_.half_power({{1, 1}, node}, 2 * exponent));
        }
        // NOTE: a number in front would get lost.
        if (!constant.factor.is_one()) { return; }
        std::erase_if(factors,
                      [&](const auto& factor) { return !varies(graph_.at(factor.first).roles); });
        if (!graph_.is_number(constant)) { factors[constant.node] = 1; }
    }

    void add_factors(Node node, Factors& factors, long& left) const {
        if (left < 0) { return; }
        if (is_product(node)) {
            for (const Node argument : graph_.at(node).arguments) {
                add_factors(argument, factors, left);
            }
        } else {
            ++factors[node];
            --left;
        }
    }

    /// Returns how often both factors stand in a product, each time with others of them.
    [[nodiscard]] static long count(const Factors& factors, const Pair& pair) {
        const auto a = factors.find(pair.first), b = factors.find(pair.second);
        if (a == factors.end() || b == factors.end()) { return 0; }
        return pair.first == pair.second ? a->second / 2 : std::min(a->second, b->second);
    }

    void count_pairs(const Factors& factors, long sign) {
        for (auto a = factors.begin(); a != factors.end(); ++a) {
            for (auto b = a; b != factors.end(); ++b) {
                const Pair pair{a->first, b->first};
                add_to_count(pair, sign * count(factors, pair));
            }
        }
    }

    void add_to_count(const Pair& pair, long more) {
        if (more == 0 || stays_.count(pair) > 0) { return; }
        long& all = counts_[pair];
        ranks_.erase({-all, pair});
        all += more;
        if (all > 1) { ranks_.insert({-all, pair}); }
    }

    /// NOTE: a copy, as ranks change.
    void take_out(const Pair pair) {
        const Scaled both = graph_.product({{1, 1}, pair.first}, {{1, 1}, pair.second});
        // NOTE: where it is a number, or has one, the pair stays as it is.
        if (graph_.is_number(both) || !both.factor.is_one()) {
            ranks_.erase(ranks_.begin());
            stays_.insert(pair);
            return;
        }
        const std::set<Node> users = users_[pair.first];
        for (const Node product : users) {
            Factors& factors = products_[product];
            const long times = count(factors, pair);
            if (times == 0) { continue; }
            count_pairs(factors, -1);
            take(product, pair.first, times);
            take(product, pair.second, times);
            factors[both.node] += times;
            users_[both.node].insert(product);
            count_pairs(factors, 1);
        }
    }

    void take(Node product, Node factor, long times) {
        Factors& factors = products_[product];
        if ((factors[factor] -= times) > 0) { return; }
        factors.erase(factor);
        users_[factor].erase(product);
    }

    /// Returns the product. NOTE: factors of equal roles first, the fewer first, so that what
    /// depends on q alone can be computed before p is known; and inverses last, as divisions.
    [[nodiscard]] Scaled multiplied(const Factors& factors) {
        std::map<std::pair<Roles, bool>, Scaled> groups;
        for (const auto& [node, exponent] : factors) {
            const Computation& computation = graph_.at(node);
            const bool is_inverse = computation.operation == Operation::inverse ||
                                    computation.operation == Operation::inverse_square_root;
            const std::pair key{computation.roles, is_inverse};
            const Scaled power = graph_.half_power({{1, 1}, node}, 2 * exponent);
            const auto [found, is_first] = groups.emplace(key, power);
            if (!is_first) { found->second = graph_.product(found->second, power); }
        }
        Scaled result = Graph::number(1);
        for (const auto& [key, group] : groups) { result = graph_.product(result, group); }
        return result;
    }

    Graph& graph_;
    Constants constants_;
    std::map<Node, Factors> products_;
    std::map<Node, std::set<Node>> users_;  ///< products that have a factor
    std::map<Pair, long> counts_;
    std::set<std::pair<long, Pair>> ranks_;  ///< pairs in several products, most of them first
    std::set<Pair> stays_;
};

bool costs_less(const Graph& graph, const std::vector<Scaled>& a, const std::vector<Scaled>& b) {
    const auto inner = [&](auto part) {
        return cost(part(graph, a).counts) <= cost(part(graph, b).counts);
    };
    return cost(kernel(graph, a).counts) < cost(kernel(graph, b).counts) &&
           inner(kernel_of_momenta) && inner(kernel_of_direction);
}

}  // namespace

std::vector<Scaled> with_common_products(Graph& graph, const std::vector<Scaled>& values) {
    std::vector<Scaled> best = values;
    for (const Constants constants : {Constants::together, Constants::apart}) {
        const std::vector<Scaled> other =
            rewritten(graph, values, CommonProducts(graph, values, constants)());
        if (costs_less(graph, other, best)) { best = other; }
    }
    return best;
}

}  // namespace hvi::gen
