// How many steps a run takes.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>

#include "generator/read/scene_times.hpp"

namespace hvi::gen {

/// Steps of one size from the time 0.
struct Steps {
    double size;         ///< the double nearest to it; negative is back in time
    std::int64_t count;  ///< the most that do not go beyond the end
    double left = 0;     ///< of the time behind them, less than a step
};

/// Decided exactly: 200 is 4000 steps of 1/20, although 200/0.05 in doubles is another number.
/// `step` and `until` may depend on these parameters, which have their values. Throws
/// MathError with its place for a step of size zero, one that leads away from the end, one of which
/// there would be more than 10^15, and times beyond the range of doubles; and as evaluate_number()
/// does.
[[nodiscard]] Steps steps_until(const SceneTimes& times, const NamedExpression& step,
                                const NamedExpression& until);

/// The double nearest to a time that may depend on these parameters. Throws as steps_until().
[[nodiscard]] double nearest_value(const SceneTimes& times, const NamedExpression& what);

}  // namespace hvi::gen
