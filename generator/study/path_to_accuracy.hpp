// How many steps a method takes to an accuracy, from runs that were measured: no clock, no runs.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "generator/study/curves.hpp"

namespace hvi::gen {

/// Puts a run among those of the curve, by rising number of steps, in place of one with as many; of
/// their times the lesser stays, as what disturbs a run makes it longer.
void add_point(WorkCurve& curve, const WorkPoint& point);

/// The timed run with an error of at most `accuracy` that took the least time.
[[nodiscard]] std::optional<WorkPoint> cheapest(const WorkCurve& curve, double accuracy);

/// With how many steps to look next for the fewest that do: by the secant of log(error) over
/// log(steps), or by the order where one run says more than two. Empty where they are known to a
/// few per cent, or smaller steps no longer help. Precondition: the curve has a point.
[[nodiscard]] std::optional<std::int64_t> next_count(const WorkCurve& curve, double accuracy);

/// The time to that accuracy, as the order makes it of the runs; the least of these. Infinite where
/// no run comes to the end.
[[nodiscard]] double predicted_seconds(const WorkCurve& curve, double accuracy);

/// Whether there is no hope to come below `seconds`. NOTE: errors that are not small yet may fall
/// faster than the order says; and where all runs are accurate enough, fewer steps cost less, of
/// which errors at round-off tell nothing. Precondition: the curve has a point.
[[nodiscard]] bool is_hopeless(const WorkCurve& curve, double accuracy, double seconds);

/// The curve whose cheapest run takes the least time.
[[nodiscard]] std::optional<std::size_t> fastest(const std::vector<WorkCurve>& curves,
                                                 double accuracy);

}  // namespace hvi::gen
