// How what is conserved departs over time, in runs that are like those of many applications.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "generator/study/curves.hpp"
#include "generator/study/work.hpp"

namespace hvi::gen {

constexpr std::int64_t departure_parts = 500;  // of a run

/// Samples the run of a point again.
using SampleDepartures = std::function<DepartureSamples(const WorkPoint&)>;

/// Over the run whose error is nearest to what is usual. Empty where all points have failed.
[[nodiscard]] Departures departures(const Course& course, const std::vector<WorkPoint>& points,
                                    const SampleDepartures& sample);

}  // namespace hvi::gen
