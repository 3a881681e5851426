// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/plan/stage_graph.hpp"

#include <algorithm>

#include "generator/ir/equal.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

using StageKind = StageNode::Kind;

}  // namespace

StageGraph::StageGraph(const StagePattern& pattern)
    : positions_(pattern.q.size()),
      momenta_(pattern.p.size()),
      needs_(2 * (positions_ + momenta_)) {
    for (std::size_t i = 0; i < positions_; ++i) {
        for (std::size_t j = 0; j < momenta_; ++j) {
            if (pattern.q[i][j]) {
                needs_[number(StageKind::Q, i)].push_back(number(StageKind::Lq, j));
            }
            if (pattern.p[j][i]) {
                needs_[number(StageKind::P, j)].push_back(number(StageKind::Lp, i));
            }
        }
    }
    for (std::size_t j = 0; j < momenta_; ++j) {
        auto& slope = needs_[number(StageKind::Lq, j)];
        slope.push_back(number(StageKind::P, j));
        if (!pattern.separable) { slope.push_back(number(StageKind::Q, j)); }
    }
    for (std::size_t i = 0; i < positions_; ++i) {
        auto& slope = needs_[number(StageKind::Lp, i)];
        slope.push_back(number(StageKind::Q, i));
        if (!pattern.separable) { slope.push_back(number(StageKind::P, i)); }
    }
}

std::size_t StageGraph::number(StageKind kind, std::size_t index) const {
    switch (kind) {
    case StageKind::Q: return index;
    case StageKind::P: return positions_ + index;
    case StageKind::Lq: return positions_ + momenta_ + index;
    case StageKind::Lp: return positions_ + 2 * momenta_ + index;
    }
    HVI_CHECK(false);
    return 0;
}

StageNode StageGraph::node(std::size_t number) const {
    if (number < positions_) { return {StageKind::Q, number}; }
    number -= positions_;
    if (number < momenta_) { return {StageKind::P, number}; }
    number -= momenta_;
    if (number < momenta_) { return {StageKind::Lq, number}; }
    return {StageKind::Lp, number - momenta_};
}

namespace {

std::vector<bool> counts(const NumberVector& numbers) {
    std::vector<bool> result;
    for (const Number& number : numbers) { result.push_back(!equal(number, 0)); }
    return result;
}

std::vector<std::vector<bool>> counts(const NumberMatrix& rows) {
    std::vector<std::vector<bool>> result;
    for (const NumberVector& row : rows) { result.push_back(counts(row)); }
    return result;
}

/// What the step depends on: the slopes that have a weight, and what these need.
std::vector<bool> used(const StageGraph& graph, const PartitionedMethod& method) {
    std::vector<bool> result(graph.needs().size());
    std::vector<std::size_t> open;
    const auto use = [&](std::size_t v) {
        if (!result[v]) { open.push_back(v); }
        result[v] = true;
    };
    for (std::size_t i = 0; i < method.stages(); ++i) {
        if (!equal(method.b[i], 0)) { use(graph.number(StageKind::Lq, i)); }
        if (!equal(method.b_tilde[i], 0)) { use(graph.number(StageKind::Lp, i)); }
    }
    while (!open.empty()) {
        const std::size_t v = open.back();
        open.pop_back();
        for (const std::size_t w : graph.needs()[v]) { use(w); }
    }
    return result;
}

}  // namespace

std::vector<std::vector<StageNode>> coupled_stages(const PartitionedMethod& method,
                                                   bool separable) {
    const StageGraph graph({counts(method.A), counts(method.A_tilde), separable});
    const std::vector<bool> is_used = used(graph, method);
    std::vector<std::vector<StageNode>> groups;
    for (const std::vector<std::size_t>& component : components(graph.needs())) {
        if (component.size() == 1 || !is_used[component.front()]) { continue; }
        std::vector<StageNode>& group = groups.emplace_back();
        for (const std::size_t number : component) {
            const StageNode node = graph.node(number);
            if (node.kind == StageKind::Q || node.kind == StageKind::P) { group.push_back(node); }
        }
    }
    return groups;
}

}  // namespace hvi::gen
