// Ranges of indices under conditions: where a term of a derivative is, and what its sums run over.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "generator/ir/sums.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

/// Indices of an element, and of sums over others, each within those before it.
struct IndexRanges {
    std::vector<Loop> element;  ///< bounds have sizes alone; none is empty
    std::vector<Loop> loops;  ///< bounds have sizes, and indices of the element and of loops before
};

/// Whether a form is at least 0 for all values of the indices and, as far as the ranges of the
/// element say, of the sizes. False where that is not found.
[[nodiscard]] bool is_never_negative(const AffineForm& form, const IndexRanges& ranges);

/// A sum over loops, where indices of the element are within other ranges too.
struct PlacedSum {
    std::vector<Loop> loops;
    std::vector<Loop> where;  ///< what the ranges of the element do not say
};

/// The loops under conditions, which are forms that are at least 0. Where either of two bounds may
/// be the narrower one there are several sums, of which each point is in one. Conditions on sizes
/// alone are taken at their values. Throws NoLoops at `place` for a condition on a multiple of an
/// index.
[[nodiscard]] std::vector<PlacedSum> placed(const IndexRanges& ranges,
                                            const std::vector<AffineForm>& conditions,
                                            const std::map<std::string, long>& sizes,
                                            const Place& place);

}  // namespace hvi::gen
