// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/stages/stage_graph.hpp"

#include <utility>

#include "generator/stages/dependency_graph.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

using StageKind = StageNode::Kind;

/// The graph of all Q, P, Lq, Lp, numbered in this order. Nodes of a kind are ordered by variable,
/// then by stage.
class StageGraph {
public:
    explicit StageGraph(const StagePattern& pattern)
        : positions_(pattern.q.size()),
          momenta_(pattern.p.size()),
          variables_(pattern.slopes.variables()),
          needs_(2 * variables_ * (positions_ + momenta_)) {
        for (std::size_t k = 0; k < variables_; ++k) {
            add(StageKind::Q, StageKind::Lq, k, pattern.q);
            add(StageKind::P, StageKind::Lp, k, pattern.p);
        }
        add(StageKind::Lq, StageKind::P, pattern.slopes.Lq_by_P);
        add(StageKind::Lq, StageKind::Q, pattern.slopes.Lq_by_Q);
        add(StageKind::Lp, StageKind::Q, pattern.slopes.Lp_by_Q);
        add(StageKind::Lp, StageKind::P, pattern.slopes.Lp_by_P);
    }

    [[nodiscard]] const DependencyGraph& needs() const { return needs_; }

    [[nodiscard]] std::size_t number(const StageNode& node) const {
        const std::size_t place = node.variable * stages(node.kind) + node.index;
        switch (node.kind) {
        case StageKind::Q: return place;
        case StageKind::P: return variables_ * positions_ + place;
        case StageKind::Lq: return variables_ * (positions_ + momenta_) + place;
        case StageKind::Lp: return variables_ * (positions_ + 2 * momenta_) + place;
        }
        HVI_CHECK(false);
        return 0;
    }

    [[nodiscard]] StageNode node(std::size_t number) const {
        for (const StageKind kind : {StageKind::Q, StageKind::P, StageKind::Lq, StageKind::Lp}) {
            const std::size_t count = stages(kind);
            if (number < variables_ * count) { return {kind, number % count, number / count}; }
            number -= variables_ * count;
        }
        HVI_CHECK(false);
        return {};
    }

private:
    [[nodiscard]] std::size_t stages(StageKind kind) const {
        return kind == StageKind::Q || kind == StageKind::Lp ? positions_ : momenta_;
    }

    /// Adds stage values of one variable that need its slopes.
    void add(StageKind value, StageKind slope, std::size_t variable, const Pattern& pattern) {
        for (std::size_t i = 0; i < pattern.size(); ++i) {
            for (std::size_t j = 0; j < pattern[i].size(); ++j) {
                if (!pattern[i][j]) { continue; }
                needs_[number({value, i, variable})].push_back(number({slope, j, variable}));
            }
        }
    }

    /// Adds slopes that need values of their stage. NOTE: a Q and a P with one index belong to one
    /// stage wherever a slope needs both.
    void add(StageKind slope, StageKind value, const Pattern& pattern) {
        for (std::size_t k = 0; k < pattern.size(); ++k) {
            for (std::size_t l = 0; l < pattern[k].size(); ++l) {
                if (!pattern[k][l]) { continue; }
                for (std::size_t i = 0; i < stages(slope); ++i) {
                    needs_[number({slope, i, k})].push_back(number({value, i, l}));
                }
            }
        }
    }

    std::size_t positions_, momenta_, variables_;
    DependencyGraph needs_;
};

Pattern counting(const NumberMatrix& rows) {
    Pattern result;
    for (const NumberVector& row : rows) {
        std::vector<bool>& counts = result.emplace_back();
        for (const Number& number : row) { counts.push_back(number.known_zero() != true); }
    }
    return result;
}

std::vector<std::vector<StageNode>> groups_in_order(const StageGraph& graph) {
    std::vector<std::vector<StageNode>> groups;
    for (const std::vector<std::size_t>& component : components(graph.needs())) {
        std::vector<StageNode>& group = groups.emplace_back();
        for (const std::size_t number : component) { group.push_back(graph.node(number)); }
    }
    return groups;
}

/// Returns the nodes that the step depends on: the slopes that have a weight, and the nodes that
/// these need.
std::vector<bool> used(const StageGraph& graph, const PartitionedMethod& method) {
    std::vector<bool> result(graph.needs().size());
    std::vector<std::size_t> open;
    const auto use = [&](std::size_t v) {
        if (!result[v]) { open.push_back(v); }
        result[v] = true;
    };
    for (std::size_t i = 0; i < method.stages(); ++i) {
        if (method.b[i].known_zero() != true) { use(graph.number({StageKind::Lq, i})); }
        if (method.b_tilde[i].known_zero() != true) { use(graph.number({StageKind::Lp, i})); }
    }
    while (!open.empty()) {
        const std::size_t v = open.back();
        open.pop_back();
        for (const std::size_t w : graph.needs()[v]) { use(w); }
    }
    return result;
}

}  // namespace

SlopePattern slopes_of_all(bool separable) {
    const Pattern yes{{true}}, unless_separable{{!separable}};
    return {unless_separable, yes, yes, unless_separable};
}

StagePattern stage_pattern(const PartitionedMethod& method, SlopePattern slopes) {
    return {counting(method.A), counting(method.A_tilde), std::move(slopes)};
}

std::vector<std::vector<StageNode>> groups_in_order(const StagePattern& pattern) {
    return groups_in_order(StageGraph(pattern));
}

std::vector<std::vector<StageNode>> coupled_stages(const PartitionedMethod& method,
                                                   bool separable) {
    const StageGraph graph(stage_pattern(method, slopes_of_all(separable)));
    const std::vector<bool> is_used = used(graph, method);
    std::vector<std::vector<StageNode>> result;
    for (const std::vector<StageNode>& group : groups_in_order(graph)) {
        if (group.size() == 1 || !is_used[graph.number(group.front())]) { continue; }
        std::vector<StageNode>& values = result.emplace_back();
        for (const StageNode& node : group) {
            if (node.kind == StageKind::Q || node.kind == StageKind::P) { values.push_back(node); }
        }
    }
    return result;
}

}  // namespace hvi::gen
