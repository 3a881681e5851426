// The dependencies among the values of a step, which order their computation.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/exact/methods/number_stages.hpp"
#include "generator/stages/stage_node.hpp"

namespace hvi::gen {

using Pattern = std::vector<std::vector<bool>>;

/// Dependencies of the slopes of a stage: Lq of the variable k needs Q of l when Lq_by_Q[k][l], ...
struct SlopePattern {
    Pattern Lq_by_Q, Lq_by_P, Lp_by_Q, Lp_by_P;

    [[nodiscard]] std::size_t variables() const { return Lq_by_Q.size(); }
};

/// Returns one pattern for all degrees of freedom together, for any H or for H = T(p) + U(q).
[[nodiscard]] SlopePattern slopes_of_all(bool separable);

/// The nonzero coefficients: Q_i takes Lq_j when q[i][j], and P_j takes Lp_i when p[j][i].
struct StagePattern {
    Pattern q, p;
    SlopePattern slopes;
};

/// Returns the coefficients of a method that are not proved to be zero.
[[nodiscard]] StagePattern stage_pattern(const PartitionedMethod& method, SlopePattern slopes);

/// Returns the groups of values of a step, each of which needs only itself and those before it.
/// Members of a larger group all depend on each other, and are solved for together; a single value
/// is evaluated. A step without larger groups is explicit.
[[nodiscard]] std::vector<std::vector<StageNode>> groups_in_order(const StagePattern& pattern);

/// Returns the stage values Q and P that a step must solve for together, for any H, or for H = T(p)
/// + U(q). Values that the step does not use are left out. A step without groups needs no solver.
[[nodiscard]] std::vector<std::vector<StageNode>> coupled_stages(const PartitionedMethod& method,
                                                                 bool separable);

}  // namespace hvi::gen
