// Whether the sums of a scene are written out, or stay loops.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "generator/read/no_loops.hpp"
#include "generator/read/written_out_scene.hpp"

namespace hvi::gen {

/// A wish of the user for sums.
enum class Unroll {
    automatic,
    yes,  ///< they are written out
    no,   ///< they stay loops
};

/// Wishes that decide beside the scene.
struct UnrollWish {
    Unroll choice = Unroll::automatic;
    std::string needed_for = {};  ///< an option that loops do not have, `--dense`; or empty
    /// Degrees of freedom that are written out where loops would do.
    std::size_t most_degrees = most_degrees_of_freedom;
};

/// A decision, and why.
struct UnrollDecision {
    bool writes_out = true;
    std::string why;
};

/// Sums are written out where no variable has an index, where H or L then has at most 2000
/// operations and as many degrees of freedom as are wished for, or where a wish needs that. Throws
/// InputError as unrolled() does for sizes and bounds.
[[nodiscard]] UnrollDecision unroll_decision(const Scene& scene, const UnrollWish& wish);

/// Whether sums may be written out that loops turn out not to have: the user has left it open, and
/// there are not more than most_degrees_of_freedom.
[[nodiscard]] bool may_write_out(const Scene& scene, Unroll wish);

/// Makes one of two results, as sums stay loops or are written out: `with_loops(decision)`, or
/// `written_out(scene, decision)`. What loops turn out not to have is written out where nothing
/// else was wished for. Throws InputError as unroll_decision() and unrolled() do.
template <class WithLoops, class WrittenOut>
auto by_unrolling(const Scene& scene, const UnrollWish& wish, WithLoops with_loops,
                  WrittenOut written_out) {
    UnrollDecision decision = unroll_decision(scene, wish);
    if (!decision.writes_out) {
        try {
            return with_loops(decision);
        } catch (const NoLoops& obstacle) {
            if (!may_write_out(scene, wish.choice)) { throw; }
            decision = {true, obstacle.what()};
        }
    }
    return written_out(unrolled(scene, decision.why), decision);
}

/// How many additions, multiplications, divisions, powers and calls of functions the expression has
/// with its sums written out; `most` where there are more. Throws InputError where a bound is no
/// whole number.
[[nodiscard]] std::size_t operations_written_out(const IndexedExpression& expression,
                                                 const WholeNumbers& known, std::size_t most);

}  // namespace hvi::gen
