// A wished run, and its summary.
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

/// A run with the steps that it is to take.
struct WishedRun {
    SceneStepper stepper;
    RunSubject subject;
    Steps steps;
    Monitors monitors = {};
    std::optional<ScaledClock> clock = {};  ///< present where steps are of scaled time
    EventWishes events = {};
    std::string events_text = {};             ///< texts of the scene's events
    std::optional<SectionAxes> section = {};  ///< axes of the picture of events
    std::vector<double> times = {};           ///< times of rows; none where rows are at steps
    std::vector<TableNote> notes = {};        ///< notes of its table
    std::vector<Reduction> reductions = {};
    std::vector<Statement> statements = {};  ///< statements on the conserved quantities
    std::string not_looked_for = {};  ///< why symmetries were not sought, and how to find them
    std::string help_on_steps = {};   ///< help for steps that are too large
    std::string shortfall = {};       ///< the accuracy that is not reached; else empty
};

/// Returns `3 of 100 steps`, or in scaled time `3 steps at t = 0.1`.
[[nodiscard]] std::string what_was_done(const WishedRun& wished, const Simulation& run);

/// Reports on standard error the part of the time that is left out at the end, if any.
void note_left_out(const Steps& asked);

/// Returns lines of names and findings.
[[nodiscard]] std::string summary(const WishedRun& wished, const Simulation& run,
                                  const MonitorFindings& found);

/// Warns where the energy changes by more than a tenth of its scale. The scale is the larger of |H|
/// at the start and of the mean size of H(q, p) - H(q, 0) during the run: H may be 0 at the start,
/// as it is defined up to a constant. NOTE: the start or the maximum of H(q, p) - H(q, 0) would not
/// do. On an ellipse of eccentricity 0.9999 it is 20 000 times H near the sun, while its mean is
/// -H.
void warn_of_energy(const Simulation& run, const WishedRun& wished);

}  // namespace hvi::gen
