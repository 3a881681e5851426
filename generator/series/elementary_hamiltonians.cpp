// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/series/elementary_hamiltonians.hpp"

#include <algorithm>
#include <utility>

#include "generator/exact/numbers/budget.hpp"
#include "generator/lower/derivative.hpp"

namespace hvi::gen {

namespace {

/// Beyond these nobody waits for the sum, nor reads it.
constexpr std::size_t most_products = 1'000'000;
constexpr std::size_t most_nodes = 300'000;

}  // namespace

ElementaryHamiltonians::ElementaryHamiltonians(System system, const Ground& ground)
    : system_(std::move(system)), inputs_(system_.q), values_(system_.graph, ground) {
    if (system_.time) { inputs_.push_back(*system_.time); }
    edges_ = inputs_.size();
    inputs_.insert(inputs_.end(), system_.p.begin(), system_.p.end());
    nodes_.emplace(Index(), system_.hamiltonian);
}

Number ElementaryHamiltonians::operator()(const Tree& tree) { return at_vertex(tree, {}, 0); }

const NumberVector& ElementaryHamiltonians::on_edge(const Tree& tree) {
    const auto known = on_edges_.find(tree.text);
    if (known != on_edges_.end()) { return known->second; }
    NumberVector result;
    for (std::size_t d = 0; d < edges_; ++d) {
        const std::size_t by = variable(d, tree.root);
        const bool is_energy = by == inputs_.size();
        result.push_back(is_energy ? Number(tree.vertices == 1 ? 1 : 0) : at_vertex(tree, {by}, 0));
    }
    return on_edges_.emplace(tree.text, std::move(result)).first->second;
}

/// The variable by which the end of an edge is a derivative: of a vertex f its p. That of the
/// time's momentum is beyond all others.
std::size_t ElementaryHamiltonians::variable(std::size_t d, Colour end) const {
    if (end == Colour::g) { return d; }
    return system_.time && d + 1 == edges_ ? inputs_.size() : edges_ + d;
}

/// The sum over the d of the edges to the children from `child` on, after those of `index`. NOTE:
/// no vertex with other edges has a derivative by the time's momentum that is not zero, and one
/// with that edge alone is never in the middle.
Number ElementaryHamiltonians::at_vertex(const Tree& tree, const Index& index, std::size_t child) {
    if (vanishes(index)) { return Number(0); }
    if (child == tree.children.size()) { return derivative(index); }
    const Tree& next = *tree.children[child];
    const NumberVector& below = on_edge(next);
    Number sum;
    for (std::size_t d = 0; d < edges_; ++d) {
        const std::size_t by = variable(d, next.root == Colour::f ? Colour::g : Colour::f);
        if (by == inputs_.size() || below[d].is_zero()) { continue; }
        Index further = index;
        further.insert(std::upper_bound(further.begin(), further.end(), by), by);
        const Number factor = at_vertex(tree, further, child + 1);
        if (factor.is_zero()) { continue; }
        count_product();
        sum = sum + factor * below[d];
    }
    return sum;
}

/// All further derivatives of what is zero are. NOTE: not of H itself, which need not be looked at.
bool ElementaryHamiltonians::vanishes(const Index& index) {
    return !index.empty() && derivative(index).is_zero();
}

Number ElementaryHamiltonians::derivative(const Index& index) { return values_(node(index)); }

const Scaled& ElementaryHamiltonians::node(const Index& index) {
    const auto known = nodes_.find(index);
    if (known != nodes_.end()) { return known->second; }
    Index before = index;
    before.pop_back();
    const Scaled function = node(before);
    const std::vector<Scaled> slopes = gradient(system_.graph, function, inputs_);
    if (system_.graph.size() > most_nodes) { throw TooLarge(); }
    for (std::size_t i = before.empty() ? 0 : before.back(); i < inputs_.size(); ++i) {
        Index further = before;
        further.push_back(i);
        nodes_.emplace(std::move(further), slopes[i]);
    }
    return nodes_.at(index);
}

void ElementaryHamiltonians::count_product() {
    if (++products_ > most_products) { throw TooLarge(); }
}

}  // namespace hvi::gen
