// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/direction_kernels.hpp"

#include <fmt/format.h>

#include <map>
#include <string_view>
#include <utility>

#include "generator/lower/derivative.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {
namespace {

/// Rows that are linear in directions, rebuilt so that each term is a direction, or a sum of
/// those, times one factor: a number, or what is kept of the point.
class LinearRows {
public:
    explicit LinearRows(Graph& graph) : graph_(graph) {}

    [[nodiscard]] DirectionKernel operator()(const std::vector<Scaled>& rows) && {
        std::vector<Scaled> results;
        for (const Scaled& row : rows) { results.push_back(rebuilt(row)); }
        DirectionKernel result;
        result.kept = kept_;
        result.along = kernel_of_direction(graph_, std::move(results));
        result.point = kernel(graph_, std::move(values_));
        return result;
    }

private:
    [[nodiscard]] bool has_direction(Node node) const {
        return has(graph_.at(node).roles, Role::direction);
    }

    /// factor * node, where the node is no product: a direction, or a sum of them.
    struct Term {
        Scaled factor;
        Node node;
    };

    [[nodiscard]] Term split(const Scaled& value) {
        Term result{Graph::number(value.factor), value.node};
        while (graph_.at(result.node).operation == Operation::product) {
            const Node a = graph_.at(result.node).arguments[0];
            const Node b = graph_.at(result.node).arguments[1];
            result.factor = graph_.product(result.factor, {{1, 1}, has_direction(a) ? b : a});
            result.node = has_direction(a) ? a : b;
        }
        return result;
    }

    /// The value, written with factors that are kept.
    [[nodiscard]] Scaled rebuilt(const Scaled& value) {
        if (value.is_zero()) { return value; }
        const Term term = split(value);
        return graph_.product(kept(term.factor), sum(term.node));
    }

    /// A direction, or a sum of terms of which no two are of the same node.
    [[nodiscard]] Scaled sum(Node node) {
        const auto found = sums_.find(node);
        if (found != sums_.end()) { return found->second; }
        const Computation computation = graph_.at(node);
        Scaled result{{1, 1}, node};
        if (computation.operation != Operation::input) {
            HVI_CHECK(computation.operation == Operation::sum);
            std::map<Node, std::vector<Scaled>> factors;
            for (const Scaled& each : computation.terms) {
                const Term term = split(each);
                factors[term.node].push_back(term.factor);
            }
            std::vector<Scaled> terms;
            for (const auto& [of, all] : factors) {
                terms.push_back(graph_.product(kept(graph_.sum(all)), sum(of)));
            }
            result = graph_.sum(std::move(terms));
        }
        return sums_[node] = result;
    }

    /// The input that a factor is for directions. NOTE: signs are outside, so that x and -x are
    /// one.
    [[nodiscard]] Scaled kept(const Scaled& factor) {
        if (!varies(graph_.at(factor.node).roles)) { return factor; }
        const SmallFraction sign{factor.factor.above < 0 ? -1 : 1, 1};
        const Scaled value = graph_.times(sign, factor);
        auto found = inputs_.find(value);
        if (found == inputs_.end()) {
            const std::string name = fmt::format("kept {}/{} of node {}", value.factor.above,
                                                 value.factor.below, value.node);
            found = inputs_.emplace(value, graph_.input(name, Role::coordinate).node).first;
            kept_.push_back(found->second);
            values_.push_back(value);
        }
        return {sign, found->second};
    }

    Graph& graph_;
    std::map<Node, Scaled> sums_;
    std::map<Scaled, Node> inputs_;
    std::vector<Node> kept_;
    std::vector<Scaled> values_;
};

/// Adds products of slopes with new inputs to the terms, and returns these.
std::vector<Node> add_directions(Graph& graph, std::string_view letter,
                                 const std::vector<Scaled>& slopes, std::vector<Scaled>& terms) {
    std::vector<Node> directions;
    for (std::size_t k = 0; k < slopes.size(); ++k) {
        const Scaled d = graph.input(fmt::format("direction of {} {}", letter, k), Role::direction);
        directions.push_back(d.node);
        terms.push_back(graph.product(slopes[k], d));
    }
    return directions;
}

}  // namespace

DirectionKernels direction_kernels(System& system) {
    HVI_CHECK(system.is_written_out() && rotations_of(system) == 0 &&
              system.side == Side::hamiltonian);
    Graph& graph = system.graph;
    DirectionKernels result;
    std::vector<Scaled> terms;
    result.dq = add_directions(graph, "q", by_coordinates(system), terms);
    result.dp = add_directions(graph, "p", by_conjugates(system), terms);
    const Scaled K = graph.sum(std::move(terms));
    const std::vector<Scaled> by_q = gradient(graph, K, coordinate_nodes(system));
    const std::vector<Scaled> by_p = gradient(graph, K, conjugate_nodes(system));
    std::vector<Scaled> both = by_q;
    both.insert(both.end(), by_p.begin(), by_p.end());
    result.by_q = LinearRows(graph)(by_q);
    result.by_p = LinearRows(graph)(by_p);
    result.both = LinearRows(graph)(both);
    return result;
}

}  // namespace hvi::gen
