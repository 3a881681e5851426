// A run that is wished for, and what is said of it.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/cli/run_monitors.hpp"
#include "generator/cli/run_section.hpp"
#include "generator/render/statements.hpp"
#include "generator/simulate/simulation.hpp"

namespace hvi::gen {

/// What is to be run, and the steps that it is to take.
struct WishedRun {
    SceneStepper stepper;
    RunSubject subject;
    Steps steps;
    Monitors monitors = {};
    std::optional<ScaledClock> clock = {};  ///< where steps are no times
    EventWishes events = {};
    std::string events_text = {};             ///< as the scene has them
    std::optional<SectionAxes> section = {};  ///< of the picture of events
    std::vector<double> times = {};           ///< of rows; none where these are at steps
    std::vector<TableNote> notes = {};        ///< that its table has
    std::vector<Reduction> reductions = {};
    std::vector<Statement> statements = {};  ///< of what it keeps
    std::string not_looked_for = {};         ///< symmetries: why, and what looks for them
    std::string help_on_steps = {};          ///< that are too large
    std::string shortfall = {};              ///< of the accuracy; empty where it is reached
};

/// `3 of 100 steps`, or in scaled time `3 steps at t = 0.1`.
[[nodiscard]] std::string what_was_done(const WishedRun& wished, const Simulation& run);

/// Says on standard error which part of the time is left out at the end, if any.
void note_left_out(const Steps& asked);

/// Lines of a name and what there is to say of it.
[[nodiscard]] std::string summary(const WishedRun& wished, const Simulation& run,
                                  const MonitorFindings& found);

/// Warns where the energy changes by more than a tenth of its scale. That is the larger of |H| at
/// the start and of the mean size of H(q, p) - H(q, 0) on the way: H may be 0 at the start, as it
/// is up to a constant. NOTE: not how much of it there is at the start, or at most. On an ellipse
/// of the eccentricity 0.9999 that is 20 000 times H where it is near the sun, and the mean is -H.
void warn_of_energy(const Simulation& run, const WishedRun& wished);

}  // namespace hvi::gen
