// The number of steps of a run.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>

#include "generator/read/scene_times.hpp"

namespace hvi::gen {

/// Steps of one size from the time 0.
struct Steps {
    double size;         ///< the nearest double; negative is back in time
    std::int64_t count;  ///< the largest number that does not pass the end
    double left = 0;     ///< the remaining time, less than a step
};

/// Counts the steps exactly: 200 is 4000 steps of 1/20, although 200/0.05 in doubles is another
/// number. `step` and `until` may depend on these parameters, which have their values. Throws
/// MathError with its place for a step of size zero, one that leads away from the end, for more
/// than 10^15 steps, and for times beyond the range of doubles; and as evaluate_number() does.
[[nodiscard]] Steps steps_until(const SceneTimes& times, const NamedExpression& step,
                                const NamedExpression& until);

/// Returns the double nearest to a number that may depend on these parameters. Throws MathError
/// where that is infinite, or 0 and the number is not; and as evaluate_number() does.
[[nodiscard]] double nearest_value(const SceneTimes& times, const NamedExpression& what);

}  // namespace hvi::gen
