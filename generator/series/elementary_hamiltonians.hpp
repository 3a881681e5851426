// The elementary Hamiltonians of a system: the derivatives of H that trees stand for.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "generator/ir/system.hpp"
#include "generator/series/node_balls.hpp"
#include "generator/series/node_values.hpp"
#include "generator/series/series_trees.hpp"

namespace hvi::gen {

/// Each vertex of a tree is a derivative of H: by q_d for an arrow on its q and by p_d for one on
/// its p. Each arrow is a sum over d: the tree of two vertices is the sum of dH/dq_d dH/dp_d (see
/// tree_weights.hpp). The time is one more coordinate, and H + e has the derivative 1 by its
/// momentum e, as in the extended phase space. A link is a sum over d and e, with the entry of the
/// inverse of d2H/dp2 between the derivatives by p_d and by p_e. `Values` computes the values of a
/// graph's nodes: NodeValues or NodeBalls.
template <class Values>
class ElementaryHamiltonians {
public:
    using Value = typename Values::Value;

    /// Gets the system's graph, and the second argument of `Values`.
    template <class What>
    ElementaryHamiltonians(System system, const What& what)
        : system_(std::move(system)),
          inputs_(coordinate_nodes(system_)),
          values_(system_.graph, what) {
        if (system_.time) { inputs_.push_back(*system_.time); }
        edges_ = inputs_.size();
        const std::vector<Node> momenta = conjugate_nodes(system_);
        inputs_.insert(inputs_.end(), momenta.begin(), momenta.end());
        nodes_.emplace(Index(), function_of(system_));
    }
    ElementaryHamiltonians(const ElementaryHamiltonians&) = delete;
    ElementaryHamiltonians& operator=(const ElementaryHamiltonians&) = delete;

    /// Returns the elementary Hamiltonian. Throws TooLarge, and MathError where the tree has a link
    /// and d2H/dp2 is singular. Precondition: the tree has two vertices or more.
    [[nodiscard]] Value operator()(const SeriesTree& tree);

    [[nodiscard]] const Values& values() const { return values_; }

private:
    using Index = std::vector<std::size_t>;  ///< the variables of a derivative, ascending

    /// Returns the values of the branch on an edge, for each d of the vertex above it.
    [[nodiscard]] const std::vector<Value>& on_edge(const SeriesTree& branch);
    [[nodiscard]] std::vector<Value> on_arrow(const SeriesTree& branch);
    [[nodiscard]] std::vector<Value> on_link(const SeriesTree& branch);
    [[nodiscard]] const std::vector<std::vector<Value>>& inverse_pp();
    [[nodiscard]] Value at_vertex(const SeriesTree& tree, const Index& index, std::size_t child);
    [[nodiscard]] bool vanishes(const Index& index);
    [[nodiscard]] Value derivative(const Index& index);
    [[nodiscard]] const Scaled& node(const Index& index);
    [[nodiscard]] std::size_t variable(std::size_t d, End end) const;
    void count_product();

    System system_;
    std::vector<Node> inputs_;  ///< coordinates, the time where it occurs, momenta
    std::size_t edges_;         ///< the number of d in the sum of an edge
    Values values_;
    std::map<Index, Scaled> nodes_;
    std::map<std::string, std::vector<Value>> on_edges_;
    std::optional<std::vector<std::vector<Value>>> inverse_pp_;
    std::size_t products_ = 0;
};

extern template class ElementaryHamiltonians<NodeValues>;
extern template class ElementaryHamiltonians<NodeBalls>;

}  // namespace hvi::gen
