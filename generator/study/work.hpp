// Costs of runs of a method, and how far off they end.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "generator/simulate/simulation.hpp"
#include "generator/study/curves.hpp"

namespace hvi::gen {

constexpr double longest_of_search = 0.5;
constexpr double longest_of_large_search = 2;  // of scenes of any size

/// The variable that steps divide.
enum class StepVariable { time, scaled_time };

/// The end that runs go to, and what they are compared with there.
struct Course {
    Reference reference;
    double until = 0;                        ///< the time; of scaled time some length, of which
                                             ///< the sizes of steps are parts
    std::int64_t first_count = 1;            ///< steps to begin a search with
    std::vector<double> steps;               ///< sizes that are wished for; empty: found by search
    bool keeps_energy = true;                ///< the exact motion does
    double longest_run = longest_of_search;  ///< seconds: no more work is looked for after it
    StepVariable variable = StepVariable::time;

    /// The size of so many steps. NOTE: no number of steps of scaled time leads to the end, so that
    /// a size that is wished for is taken as it is.
    [[nodiscard]] double size_of(std::int64_t count) const;
};

constexpr double seconds_of_timing = 0.05;  // of each point, in each round

[[nodiscard]] WorkPoint work_point(const Course& course, const Measurement& run);

/// Measures a run in so many equal steps, timed over so many seconds.
using MeasureSteps = std::function<Measurement(std::int64_t count, double seconds)>;

/// Measures so many equal steps until the end of the course.
[[nodiscard]] WorkPoint work_point(const Course& course, const MeasureSteps& measure,
                                   std::int64_t count, double seconds);

/// Runs of sizes that are wished for, or else such that errors go from 1e-2 to round-off.
[[nodiscard]] std::vector<WorkPoint> work_points(const Course& course, const MeasureSteps& measure);

/// Makes the run of a point once more.
using MeasureAgain = std::function<Measurement(const WorkPoint&, double seconds)>;

/// One more round of timing; of each point the faster one counts. NOTE: other programs take from a
/// shared machine what they want for seconds at a time, in which a code that keeps the processor
/// busy loses a third of its speed and one that waits for its own results nothing. Points that take
/// longer than a round allows for are timed once.
void time_again(std::vector<WorkPoint>& points, const MeasureAgain& measure);

}  // namespace hvi::gen
