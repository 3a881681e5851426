// Measurements of the ends and costs of runs with jumps, kinks and scaled time.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "generator/drive/eventful_run.hpp"
#include "generator/simulate/answers.hpp"
#include "generator/simulate/simulation.hpp"

namespace hvi::gen {

/// The end of such a run, and its cost.
struct EventfulMeasurement {
    Measurement run;
    double t = 0;                           ///< the time at the end
    std::vector<std::int64_t> events = {};  ///< the number of occurrences of each
    std::vector<double> outputs = {};       ///< the first coordinate at the wished times
};

/// Measures a run. Throws as ask() does. Precondition: the target is no Program, and no samples are
/// wished for.
[[nodiscard]] EventfulMeasurement measure(const Target& target, const EventfulRunWishes& wishes);

/// Returns the departures of conserved quantities, in parts of the run. Throws as ask() does.
[[nodiscard]] DepartureSamples sample_departures(const Target& target,
                                                 const EventfulRunWishes& wishes);

}  // namespace hvi::gen
