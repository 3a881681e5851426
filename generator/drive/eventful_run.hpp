// Measures ends and costs of runs with jumps, kinks and scaled time.
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
    std::int64_t steps = 0;  ///< the most steps, if there is a clock
    std::vector<DrivenEvent> events = {};
    std::optional<ScaledClock> clock = {};
    std::vector<double> times = {};  ///< sampled, in the order of the run
    double seconds = 0;              ///< for timing repetitions; 0 for none
    std::int64_t samples = 0;        ///< samples of departures, in place of the rest; 0 for none
};

/// Takes the run, and reports its end as src/driver/measure.hpp does, with the time there, the
/// number of each event and the first coordinate at each of the times; or reports samples of
/// departures. Returns the exit status 0 also where a step failed.
[[nodiscard]] int take_eventful_run(const EventfulRunWishes& wishes);

}  // namespace hvi::gen
