// Times at which a run writes rows: `--times FROM:TO:COUNT`.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "generator/read/scene_times.hpp"
#include "generator/scene/step_count.hpp"

namespace hvi::gen {

/// Evenly spaced times, including the first and the last. Both of these may depend on parameters.
struct OutputTimes {
    Given from, to;
    long count = 1;
};

/// Reads FROM:TO:COUNT. Throws InputError for another number of parts, and for a COUNT that is no
/// whole number from 1 to 10 million.
[[nodiscard]] OutputTimes output_times(const Given& text);

/// Returns steps that reach the last of the times: one step more where that time is no multiple of
/// steps. Returns `steps` where there are no times.
[[nodiscard]] Steps steps_to_output(Steps steps, const std::optional<OutputTimes>& times);

/// Returns the times as numbers, in their order, for a run of steps of this size (and sign) to
/// `end`. Throws InputError where the times run against the steps, begin before the run or end
/// after it, and MathError as nearest_value() does.
[[nodiscard]] std::vector<double> values_of(const OutputTimes& times, const SceneTimes& scene,
                                            double step, double end);

}  // namespace hvi::gen
