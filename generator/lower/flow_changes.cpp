// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/flow_changes.hpp"

#include <algorithm>
#include <utility>

namespace hvi::gen {

Scaled FlowChanges::over_time(const Scaled& value) const {
    Scaled fixed = graph_.times(value.factor, tau_), rest{{1, 1}, value.node};
    const Computation computation = graph_.at(value.node);
    const auto varies_at = [&](Node node) { return varies(graph_.at(node).roles); };
    if (computation.operation == Operation::product) {
        const auto [a, b] = std::pair(computation.arguments[0], computation.arguments[1]);
        const bool varies_a = varies_at(a);
        if (varies_a != varies_at(b)) {
            fixed = graph_.product(fixed, Scaled{{1, 1}, varies_a ? b : a});
            rest = {{1, 1}, varies_a ? a : b};
        }
    }
    return graph_.product(graph_.settled(fixed), rest);
}

void FlowChanges::add(bool is_conjugate, std::size_t component, const Scaled& change) {
    if (!change.is_zero()) { moved_.push_back({is_conjugate, component, change}); }
}

Flow FlowChanges::flow(std::string kind) && {
    std::sort(moved_.begin(), moved_.end(), [](const Moved& left, const Moved& right) {
        return std::pair(left.is_conjugate, left.component) <
               std::pair(right.is_conjugate, right.component);
    });
    return {std::move(kind), std::move(moved_), {}, std::move(in_each_flow_), std::move(forms_)};
}

}  // namespace hvi::gen
