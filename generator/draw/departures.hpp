// Departures of what is kept over time: lines, or bands where lines would run into each other.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "generator/draw/trajectory.hpp"

namespace hvi::gen {

/// A panel of departures, in units of one power of ten.
struct DeparturesPanel {
    std::string title, script;
};

/// The departures of the kept quantities from `begin` to before `end` from what they were at the
/// start. One that swings too often for a line is a band: in each part of the run the range from
/// the least to the largest value, shaded, and the mean as a line. So a drift, which moves the
/// mean, is told from oscillations, which widen the band. Throws EnvironmentError where the table
/// cannot be read.
[[nodiscard]] DeparturesPanel departures_panel(const TrajectoryPicture& picture, std::size_t begin,
                                               std::size_t end);

}  // namespace hvi::gen
