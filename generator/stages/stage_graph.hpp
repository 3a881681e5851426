// Which values of a step depend on which, and so the order in which they are computed.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/exact/methods/number_stages.hpp"
#include "generator/stages/stage_node.hpp"

namespace hvi::gen {

using Pattern = std::vector<std::vector<bool>>;

/// What the slopes of a stage depend on: Lq of the variable k on Q of l when Lq_by_Q[k][l], ...
struct SlopePattern {
    Pattern Lq_by_Q, Lq_by_P, Lp_by_Q, Lp_by_P;

    [[nodiscard]] std::size_t variables() const { return Lq_by_Q.size(); }
};

/// All degrees of freedom as one, for any H or for H = T(p) + U(q).
[[nodiscard]] SlopePattern slopes_of_all(bool separable);

/// The coefficients that count: Q_i takes Lq_j when q[i][j], and P_j takes Lp_i when p[j][i].
struct StagePattern {
    Pattern q, p;
    SlopePattern slopes;
};

/// The coefficients of a method that are not proved to be zero.
[[nodiscard]] StagePattern stage_pattern(const PartitionedMethod& method, SlopePattern slopes);

/// The groups of values of a step, each of which needs only itself and those before it. Of a group
/// of several all depend on all, and they are solved for at once; one alone is evaluated. Where
/// there is no group of several the step is explicit.
[[nodiscard]] std::vector<std::vector<StageNode>> groups_in_order(const StagePattern& pattern);

/// The stage values Q and P that a step of a method must solve for at once, whatever H is, or for
/// H = T(p) + U(q). Values that the step does not use are left out. Where there is no group a step
/// needs no solver.
[[nodiscard]] std::vector<std::vector<StageNode>> coupled_stages(const PartitionedMethod& method,
                                                                 bool separable);

}  // namespace hvi::gen
