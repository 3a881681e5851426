// Times at which a run writes rows: `--times FROM:TO:COUNT`.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "generator/read/scene_times.hpp"
#include "generator/scene/step_count.hpp"

namespace hvi::gen {

/// So many times, evenly spaced, the first and the last among them. Both may depend on parameters.
struct OutputTimes {
    Given from, to;
    long count = 1;
};

/// Reads FROM:TO:COUNT. Throws InputError for another number of parts, and for a COUNT that is no
/// whole number from 1 to 10 million.
[[nodiscard]] OutputTimes output_times(const Given& text);

/// Steps that reach the last of the times, where there are some: one more where the time is no
/// multiple of steps.
[[nodiscard]] Steps steps_to_output(Steps steps, const std::optional<OutputTimes>& times);

/// The times as numbers, in their order, of a run of steps of this size, or sign, to the end.
/// Throws InputError where they lead away from where the steps lead, begin before the run or end
/// behind it, and MathError as nearest_value() does.
[[nodiscard]] std::vector<double> values_of(const OutputTimes& times, const SceneTimes& scene,
                                            double step, double end);

}  // namespace hvi::gen
