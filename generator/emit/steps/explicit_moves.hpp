// The kicks and drifts of a step that solves nothing.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "generator/ir/step.hpp"

namespace hvi::gen {

/// NOTE: in an explicit step for separable H every m_ij is 0 or 1, since one that is neither
/// makes Q_i and P_j depend on each other. So each stage value is the one before it plus one slope:
/// p -= h b dH/dq and q += h b dH/dp in turn, in the order of the blocks.
struct Move {
    bool kick;          // of p, else a drift of q
    std::size_t index;  // of the slope
};

[[nodiscard]] std::vector<Move> moves(const Step& step);

/// Names that kicks and drifts have for their parts.
struct MoveNames {
    std::string_view moved;  // p
    std::string_view gradient, sign, weights, kept;
};

[[nodiscard]] const MoveNames& names(const Move& move);
[[nodiscard]] const MoveNames& other_names(const Move& move);

/// Whether the first slope of kicks, or of drifts, may be the last one of the step before.
[[nodiscard]] bool keeps(const Step& step, bool of_kick);

/// The vector of the slope, and the call that evaluates it at `at`.
[[nodiscard]] std::string slope(const Step& step, const Move& move);
[[nodiscard]] std::string evaluation(const Step& step, const Move& move, std::string_view at);
/// The call with another vector.
[[nodiscard]] std::string evaluation(const Step& step, const Move& move, std::string_view at,
                                     const std::string& out);

/// h b, with which a move takes its slope.
[[nodiscard]] std::string size(const Step& step, const Move& move);

/// h b times component k of the slope, with h b computed there and then.
[[nodiscard]] std::string change(const Step& step, const Move& move, std::string_view k);

/// The moves where increments are summed apart, see src/hvi/detail/stages/step_sums.hpp, and the
/// vectors that they compute in and leave nothing in.
[[nodiscard]] std::string compensated_moves_text(const Step& step);
[[nodiscard]] std::vector<std::string> compensated_scratch(const Step& step);

/// Where increments are summed apart, the member that has h times b_p and b_q.
[[nodiscard]] std::string weights_member(const Step& step);

/// The step of trajectories side by side.
[[nodiscard]] std::string ensemble_moves_text(const Step& step, Sums sums, std::size_t dimension);

/// The moves of a step whose trajectories are threads.
[[nodiscard]] std::string thread_moves_text(const Step& step, Sums sums, std::size_t dimension);

/// The references to vectors that a step computes in.
[[nodiscard]] std::string scratch_text(const std::vector<std::string>& names);

}  // namespace hvi::gen
