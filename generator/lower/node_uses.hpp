// Uses of the nodes of a graph by results, and what the computation of these costs, while results
// change.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <vector>

#include "generator/graph/graph.hpp"

namespace hvi::gen {

/// Numbers of uses of a node: all, and those in products.
struct UseCount {
    std::size_t all = 0;
    std::size_t in_products = 0;
};

/// The nodes that results need, each with its uses by those and by the results. NOTE: costs are
/// those of kernel(), but for few changes they take a small part of its time.
class NodeUses {
public:
    explicit NodeUses(const Graph& graph) : graph_(graph) {}

    void take(Node node, const UseCount& uses) { change(node, uses, true); }
    void drop(Node node, const UseCount& uses) { change(node, uses, false); }

    /// Bans a node that is not in use from any use.
    void ban(Node node) { is_banned_[node] = true; }
    /// Returns whether no banned node is in use.
    [[nodiscard]] bool bans_hold() const { return banned_in_use_ == 0; }

    [[nodiscard]] UseCount of(Node node) const {
        return node < uses_.size() ? uses_[node] : UseCount{};
    }
    /// Returns whether the root of a node is in use, or 1/root.
    [[nodiscard]] bool has_root(Node node) const {
        const auto found = roots_.find(node);
        return found != roots_.end() && found->second > 0;
    }
    /// Returns the cost of all nodes in use, as cost() of kernel.hpp does.
    [[nodiscard]] double cost() const { return cost_; }

private:
    void change(Node node, const UseCount& uses, bool takes);
    [[nodiscard]] double cost_of(Node node) const;
    void count_root(Node argument, bool takes);

    const Graph& graph_;
    std::vector<UseCount> uses_;
    std::vector<bool> is_banned_;
    std::size_t banned_in_use_ = 0;
    std::map<Node, std::size_t> roots_;  ///< how many nodes in use have the root of a node
    double cost_ = 0;
};

}  // namespace hvi::gen
