// Runs with jumps, kinks and scaled time, of which ends and costs are asked.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "generator/drive/eventful_run.hpp"
#include "generator/simulate/answers.hpp"
#include "generator/simulate/simulation.hpp"

namespace hvi::gen {

/// Where such a run ends and what it costs.
struct EventfulMeasurement {
    Measurement run;
    double t = 0;                           ///< at the end
    std::vector<std::int64_t> events = {};  ///< how many there were of each
    std::vector<double> outputs = {};       ///< the first coordinate at times that are asked for
};

/// Throws as ask() does. Precondition: the target is no Program, and no samples are wished for.
[[nodiscard]] EventfulMeasurement measure(const Target& target, const EventfulRunWishes& wishes);

/// The departures of what is conserved, in parts of the run. Throws as ask() does.
[[nodiscard]] DepartureSamples sample_departures(const Target& target,
                                                 const EventfulRunWishes& wishes);

}  // namespace hvi::gen
