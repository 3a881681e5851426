// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/node_uses.hpp"

#include <algorithm>
#include <utility>

#include "generator/lower/kernel.hpp"

namespace hvi::gen {

void NodeUses::change(Node first, const UseCount& uses, bool takes) {
    uses_.resize(graph_.size());
    is_banned_.resize(graph_.size());
    // NOTE: a stack, since graphs are deep.
    std::vector<std::pair<Node, UseCount>> left{{first, uses}};
    while (!left.empty()) {
        const auto [node, by] = left.back();
        left.pop_back();
        UseCount& count = uses_[node];
        const bool was_used = count.all > 0;
        cost_ -= cost_of(node);
        count.all = takes ? count.all + by.all : count.all - by.all;
        count.in_products =
            takes ? count.in_products + by.in_products : count.in_products - by.in_products;
        cost_ += cost_of(node);
        const Computation& computation = graph_.at(node);
        if (was_used == (count.all > 0)) { continue; }
        if (is_banned_[node]) { takes ? ++banned_in_use_ : --banned_in_use_; }
        if (!varies(computation.roles)) { continue; }
        const bool is_root = computation.operation == Operation::square_root ||
                             computation.operation == Operation::inverse_square_root;
        if (is_root) { count_root(computation.arguments.front(), takes); }
        const bool is_product = computation.operation == Operation::product;
        for (const Scaled& term : computation.terms) { left.push_back({term.node, {1, 0}}); }
        for (const Node argument : computation.arguments) {
            left.push_back({argument, {1, is_product ? 1U : 0U}});
        }
    }
}

void NodeUses::count_root(Node argument, bool takes) {
    std::size_t& count = roots_[argument];
    if (!takes) { --count; }
    if (count == 0) { cost_ += takes ? cost_of_root : -cost_of_root; }
    if (takes) { ++count; }
}

double NodeUses::cost_of(Node node) const {
    const UseCount& uses = uses_[node];
    const Computation& computation = graph_.at(node);
    if (uses.all == 0 || !varies(computation.roles)) { return 0; }
    // NOTE: a product with an inverse that nothing else needs is a division.
    const double saved = uses.all == 1 && uses.in_products == 1 ? 1 : 0;
    switch (computation.operation) {
    case Operation::constant:
    case Operation::input:
    case Operation::square_root: return 0;  // see count_root()
    case Operation::sum: {
        const auto takes_product = [&](const Scaled& term) {
            return !graph_.is_number(term) && !term.factor.size().is_one();
        };
        const auto products =
            std::count_if(computation.terms.begin(), computation.terms.end(), takes_product);
        return static_cast<double>(computation.terms.size() - 1) + static_cast<double>(products);
    }
    case Operation::product: return 1;
    case Operation::inverse:
    case Operation::inverse_square_root: return cost_of_division - saved;
    case Operation::power:
    case Operation::call: return cost_of_call;
    }
    return 0;
}

}  // namespace hvi::gen
