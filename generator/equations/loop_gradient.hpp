// Derivatives of a Hamiltonian whose sums stay loops, by the element with any index.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <set>
#include <string>
#include <vector>

#include "generator/ir/system.hpp"

namespace hvi::gen {

/// A part of a derivative: it counts where each index of `where` is within its range.
struct LoopTermOfSlope {
    Expression value;
    std::vector<Loop> where;  ///< narrower than the ranges of the element; several of an index hold
};

/// dH/dx[k], as the sum of its terms.
using ElementSlope = std::vector<LoopTermOfSlope>;

/// The first derivatives of H by the elements of all families. Expressions have elements and sums
/// over indices, as what a reader of indices returns.
struct LoopGradient {
    std::vector<std::string> indices;          ///< of an element; a family has the first of them
    std::vector<ElementSlope> by_coordinates;  ///< of each family
    std::vector<ElementSlope> by_momenta;
};

/// A sum over k of f(x[k], x[k+1]) has two terms by x[k], from the summands with the indices k and
/// k-1. Throws NoLoops at `place` where a summand cannot be told from an index of its element: from
/// 2*i, or from a mod that does not take each value once; and where a derivative is too long.
/// No index has a name of the system, nor one that is `taken`.
[[nodiscard]] LoopGradient loop_gradient(const System& system,
                                         const std::vector<std::string>& taken, const Place& place);

/// All names of the system, those of indices too.
[[nodiscard]] std::set<std::string> names_in(const System& system);

/// The element with these indices, or what has none.
[[nodiscard]] Expression element_of(const SystemFamily& family,
                                    const std::vector<std::string>& indices);

/// `x[1..N]`
[[nodiscard]] std::string to_text(const SystemFamily& family);

/// H itself, with its sums.
[[nodiscard]] Expression with_sums(const System& system, const Place& place);

}  // namespace hvi::gen
