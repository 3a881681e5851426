// Which values of a step depend on which.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/exact/methods/number_stages.hpp"
#include "generator/ir/step.hpp"
#include "generator/plan/graph.hpp"

namespace hvi::gen {

/// The coefficients that count: Q_i takes Lq_j when q[i][j], and P_j takes Lp_i when p[j][i].
struct StagePattern {
    std::vector<std::vector<bool>> q, p;
    bool separable = false;  ///< Lq_j depends on P_j alone, and Lp_i on Q_i
};

/// The graph of all Q, P, Lq, Lp, numbered in this order.
class StageGraph {
public:
    explicit StageGraph(const StagePattern& pattern);

    [[nodiscard]] const DependencyGraph& needs() const { return needs_; }
    [[nodiscard]] std::size_t number(StageNode::Kind kind, std::size_t index) const;
    [[nodiscard]] StageNode node(std::size_t number) const;

private:
    std::size_t positions_, momenta_;
    DependencyGraph needs_;
};

/// The stage values Q and P that a step of a method must solve for at once, whatever H is, or for
/// H = T(p) + U(q): in each group all depend on all. Values that the step does not use are left
/// out; a coefficient that is not proved to be zero counts. Where there is no group a step needs no
/// solver.
[[nodiscard]] std::vector<std::vector<StageNode>> coupled_stages(const PartitionedMethod& method,
                                                                 bool separable);

}  // namespace hvi::gen
