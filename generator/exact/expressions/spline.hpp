// B-splines: piecewise polynomials on [0, 1].
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>

#include "generator/exact/functions/function.hpp"
#include "generator/read/parse.hpp"

namespace hvi::gen {

/// Index of `bspline(k,i)`: the i-th B-spline of degree k, i = 0, 1, ...
struct SplineIndex {
    long degree = 0;
    long index = 0;
};

/// Returns the index of a call. Precondition: a call of bspline as the reader lets it pass.
[[nodiscard]] SplineIndex spline_index(const Expression& call);

/// Returns, for each degree k of a B-spline in the list, the number of B-splines: one more than the
/// largest index.
///
/// NOTE: the largest index, not the number of items, so that a combination of several B-splines may
/// stand in one item, and one may be left out where `1` takes its place.
[[nodiscard]] std::map<long, long> spline_counts(const List& list);

/// Returns the i-th of `count` B-splines of degree k: with m = count - k intervals of equal length,
/// clamped, that is, on the knots 0 (k+1 times), 1/m, 2/m, ..., 1 (k+1 times). B-splines are not
/// negative, and their sum is 1. At a jump of degree 0 the value is that on the right; outside [0,
/// 1] the first and the last piece go on. Precondition: count > k, index < count.
///
/// C. de Boor, A Practical Guide to Splines, Chapter IX.
[[nodiscard]] ExactFunction b_spline(const SplineIndex& which, long count, const Ground& ground);

}  // namespace hvi::gen
