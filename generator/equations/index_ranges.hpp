// Ranges of indices under conditions: the elements that have a term of a derivative, and its sums.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "generator/ir/sums.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

/// Indices of an element, and of sums over others. Bounds of an index use earlier ones only.
struct IndexRanges {
    std::vector<Loop> element;  ///< bounds have sizes alone; none is empty
    std::vector<Loop> loops;  ///< bounds have sizes, and indices of the element and of loops before
};

/// Whether a form is at least 0 for all values of the indices and, as far as the ranges of the
/// element tell, of the sizes. False where that is not found.
[[nodiscard]] bool is_never_negative(const AffineForm& form, const IndexRanges& ranges);

/// A sum over loops. Ranges in `where` restrict the indices of the element.
struct PlacedSum {
    std::vector<Loop> loops;
    std::vector<Loop> where;  ///< conditions beyond the ranges of the element
};

/// Returns the loops under conditions, which are forms that must be at least 0. Where either of two
/// bounds may be the narrower one there are several sums, and each point is in one of them.
/// Conditions on sizes alone are decided by the sizes' values. Throws NoLoops at `place` for a
/// condition on a multiple of an index.
[[nodiscard]] std::vector<PlacedSum> placed(const IndexRanges& ranges,
                                            const std::vector<AffineForm>& conditions,
                                            const std::map<std::string, long>& sizes,
                                            const Place& place);

}  // namespace hvi::gen
