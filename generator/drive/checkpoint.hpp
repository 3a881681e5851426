// Checkpoints: places of a run from which it can resume.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <hvi/detail/module/departure.hpp>
#include <hvi/detail/trajectories/event_steps.hpp>

#include "generator/drive/driven_stepper.hpp"

namespace hvi::gen {

using EventMemory = detail::EventSteps<DrivenStepper>::Memory;

/// The data from which a run resumes. Its bits are those of a run that at this place forgets what
/// its steps have remembered. Numbers are those of DrivenProblem.
struct Checkpoint {
    std::int64_t steps = 0, iterations = 0, evaluations = 0;
    double t = 0;
    std::vector<double> state = {};  ///< q, p, and the time where H depends on it
    std::vector<detail::Departure> departures = {};
    double motion = 0;  ///< sum of an EnergyOfMotion, with the number below
    std::int64_t motions = 0;
    std::vector<EventMemory> events = {};
    std::vector<std::int64_t> counts = {};  ///< numbers of events
    std::vector<double> reductions = {};    ///< the memory of Reductions
    std::vector<std::int64_t> sizes =
        {};  ///< bytes of the tables so far, then of the table of events
    std::vector<std::int64_t> rows = {};  ///< rows of the tables
};

/// Returns the checkpoint as lines, with their digest at the end. The key identifies the run.
[[nodiscard]] std::string text(const Checkpoint& checkpoint, const std::string& key);

/// Returns the last whole checkpoint in the text of a file, for a run with this key. Throws
/// InputError, with the place of the file's name, where there is none, and where it belongs to
/// another run.
[[nodiscard]] Checkpoint last_checkpoint(const std::string& text, const std::string& key,
                                         const std::filesystem::path& file);

}  // namespace hvi::gen
