// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/series/elementary_hamiltonians.hpp"

#include <algorithm>
#include <utility>

#include "generator/exact/numbers/budget.hpp"
#include "generator/lower/derivative.hpp"

namespace hvi::gen {

namespace {

/// Limits: a longer sum takes too long, and nobody reads it.
constexpr std::size_t most_products = 1'000'000;
constexpr std::size_t most_nodes = 300'000;

}  // namespace

template <class Values>
auto ElementaryHamiltonians<Values>::operator()(const SeriesTree& tree) -> Value {
    return at_vertex(tree, {}, 0);
}

template <class Values>
auto ElementaryHamiltonians<Values>::on_edge(const SeriesTree& branch)
    -> const std::vector<Value>& {
    const auto known = on_edges_.find(branch.text);
    if (known != on_edges_.end()) { return known->second; }
    auto result = branch.above == End::link ? on_link(branch) : on_arrow(branch);
    return on_edges_.emplace(branch.text, std::move(result)).first->second;
}

template <class Values>
auto ElementaryHamiltonians<Values>::on_arrow(const SeriesTree& branch) -> std::vector<Value> {
    std::vector<Value> result;
    for (std::size_t d = 0; d < edges_; ++d) {
        const std::size_t by = variable(d, *branch.above);
        const bool is_energy = by == inputs_.size();
        result.push_back(is_energy ? Values::integer(branch.children.empty() ? 1 : 0)
                                   : at_vertex(branch, {by}, 0));
    }
    return result;
}

/// NOTE: the time's momentum has no second derivative, and the times of the stages no freedom.
template <class Values>
auto ElementaryHamiltonians<Values>::on_link(const SeriesTree& branch) -> std::vector<Value> {
    std::vector<Value> result(edges_, Values::integer(0));
    for (std::size_t e = 0; e < system_.degrees_of_freedom(); ++e) {
        const Value below = at_vertex(branch, {variable(e, End::link)}, 0);
        if (Values::is_zero(below)) { continue; }
        for (std::size_t d = 0; d < system_.degrees_of_freedom(); ++d) {
            count_product();
            result[d] = Values::sum(result[d], Values::product(inverse_pp()[d][e], below));
        }
    }
    return result;
}

template <class Values>
auto ElementaryHamiltonians<Values>::inverse_pp() -> const std::vector<std::vector<Value>>& {
    if (inverse_pp_) { return *inverse_pp_; }
    std::vector<std::vector<Value>> pp;
    for (const std::vector<Scaled>& row : hessian_of(system_).conjugates) {
        pp.emplace_back();
        for (const Scaled& entry : row) { pp.back().push_back(values_(entry)); }
    }
    return inverse_pp_.emplace(Values::inverse(pp));
}

/// Returns the variable of the derivative at the end of an edge. The time's momentum has a number
/// beyond all others.
template <class Values>
std::size_t ElementaryHamiltonians<Values>::variable(std::size_t d, End end) const {
    if (end == End::q) { return d; }
    return system_.time && d + 1 == edges_ ? inputs_.size() : edges_ + d;
}

/// Returns the sum over the d of the edges to the children from `child` on, after those of `index`.
/// NOTE: a vertex with other edges has no derivative by the time's momentum that is not zero, and a
/// vertex with this edge alone is never in the middle.
template <class Values>
auto ElementaryHamiltonians<Values>::at_vertex(const SeriesTree& tree, const Index& index,
                                               std::size_t child) -> Value {
    if (vanishes(index)) { return Values::integer(0); }
    if (child == tree.children.size()) { return derivative(index); }
    const SeriesTree& next = *tree.children[child];
    const std::vector<Value>& below = on_edge(next);
    Value sum = Values::integer(0);
    for (std::size_t d = 0; d < edges_; ++d) {
        const std::size_t by = variable(d, other(*next.above));
        if (by == inputs_.size() || Values::is_zero(below[d])) { continue; }
        Index further = index;
        further.insert(std::upper_bound(further.begin(), further.end(), by), by);
        const Value factor = at_vertex(tree, further, child + 1);
        if (Values::is_zero(factor)) { continue; }
        count_product();
        sum = Values::sum(sum, Values::product(factor, below[d]));
    }
    return sum;
}

/// Whether a derivative vanishes, as all further derivatives of zero do. NOTE: H itself is not
/// looked at.
template <class Values>
bool ElementaryHamiltonians<Values>::vanishes(const Index& index) {
    return !index.empty() && Values::is_zero(derivative(index));
}

template <class Values>
auto ElementaryHamiltonians<Values>::derivative(const Index& index) -> Value {
    return values_(node(index));
}

template <class Values>
const Scaled& ElementaryHamiltonians<Values>::node(const Index& index) {
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

template <class Values>
void ElementaryHamiltonians<Values>::count_product() {
    if (++products_ > most_products) { throw TooLarge(); }
}

template class ElementaryHamiltonians<NodeValues>;
template class ElementaryHamiltonians<NodeBalls>;

}  // namespace hvi::gen
