// Derivatives of a Hamiltonian whose sums stay loops, by the element with any index.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <set>
#include <string>
#include <vector>

#include "generator/ir/system.hpp"

namespace hvi::gen {

/// A part of a derivative. It is 0 unless each index of `where` is within its range.
struct LoopTermOfSlope {
    Expression value;
    std::vector<Loop> where;  ///< narrower than the element's ranges; an index may occur repeatedly
};

/// The derivative dH/dx[k], as the sum of its terms.
using ElementSlope = std::vector<LoopTermOfSlope>;

/// The first derivatives of H by the elements of all families. The expressions have elements and
/// sums over indices, as parse_indexed_expression() returns them.
struct LoopGradient {
    std::vector<std::string> indices;  ///< indices of an element; a family has the first of them
    std::vector<ElementSlope> by_coordinates;  ///< one for each family
    std::vector<ElementSlope> by_momenta;
};

/// Returns the derivatives. A sum over k of f(x[k], x[k+1]) has two terms by x[k], from the
/// summands with the indices k and k-1. Throws NoLoops at `place` where an index of an element does
/// not determine the summand: 2*i, or a mod that does not take each value once; and where a
/// derivative is too long. No index gets a name of the system, nor one that is `taken`.
[[nodiscard]] LoopGradient loop_gradient(const System& system,
                                         const std::vector<std::string>& taken, const Place& place);

/// Returns all names of the system, including indices.
[[nodiscard]] std::set<std::string> names_in(const System& system);

/// Returns the element with these indices, or a symbol for a family without indices.
[[nodiscard]] Expression element_of(const SystemFamily& family,
                                    const std::vector<std::string>& indices);

/// Returns `x[1..N]`.
[[nodiscard]] std::string to_text(const SystemFamily& family);

/// Returns H itself, with its sums.
[[nodiscard]] Expression with_sums(const System& system, const Place& place);

}  // namespace hvi::gen
