// Decides whether the sums of a scene are written out, or stay loops.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "generator/read/no_loops.hpp"
#include "generator/read/written_out_scene.hpp"

namespace hvi::gen {

/// The user's choice for sums.
enum class Unroll {
    automatic,
    yes,  ///< they are written out
    no,   ///< they stay loops
};

/// Wishes that influence the decision beside the scene.
struct UnrollWish {
    Unroll choice = Unroll::automatic;
    std::string needed_for = {};  ///< an option that loops do not support, or empty
    /// The most degrees of freedom for which sums are written out although loops would do.
    std::size_t most_degrees = most_degrees_of_freedom;
};

/// A decision, and its reason.
struct UnrollDecision {
    bool writes_out = true;
    std::string why;
};

/// Decides whether sums are written out. They are where no variable has an index, where a wish
/// needs it, and where H or L then has at most 2000 operations and no more degrees of freedom than
/// `wish` allows. Throws InputError as unrolled() does for sizes and bounds.
[[nodiscard]] UnrollDecision unroll_decision(const Scene& scene, const UnrollWish& wish);

/// Whether sums may be written out after loops turned out to be unsupported: the user has left the
/// choice open, and there are at most most_degrees_of_freedom.
[[nodiscard]] bool may_write_out(const Scene& scene, Unroll wish);

/// Returns with_loops(decision) where sums stay loops, and written_out(scene, decision) where they
/// are written out. Writes sums out after all where loops turn out to be unsupported and the user
/// has left the choice open. Throws InputError as unroll_decision() and unrolled() do.
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

/// Counts the additions, multiplications, divisions, powers and calls of functions of the
/// expression with its sums written out; returns `most` where there are more. Throws InputError
/// where a bound is no whole number.
[[nodiscard]] std::size_t operations_written_out(const IndexedExpression& expression,
                                                 const WholeNumbers& known, std::size_t most);

}  // namespace hvi::gen
