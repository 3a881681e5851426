// Runs with jumps, kinks and scaled time whose ends and costs are measured.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "generator/drive/driven_event.hpp"

namespace hvi::gen {

/// A run of DrivenProblem to its end.
struct EventfulRunWishes {
    double h = 0;
    std::int64_t steps = 0;  ///< with a clock the most that are taken
    std::vector<DrivenEvent> events = {};
    std::optional<ScaledClock> clock = {};
    std::vector<double> times = {};  ///< at which it looks at the state, in the order of the run
    double seconds = 0;              ///< over which repetitions are timed; 0: none are
    std::int64_t samples = 0;        ///< of departures, in place of all else, where there are some
};

/// Takes the run, and says as src/driver/measure.hpp does where it ends, and besides the time
/// there, how often each event came and the first coordinate at each of the times; or samples of
/// departures. The status of its end is 0 also where a step failed.
[[nodiscard]] int take_eventful_run(const EventfulRunWishes& wishes);

}  // namespace hvi::gen
