// Places of a run from which it can go on.
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

/// All that a run goes on from: its bits are those of a run that has forgotten, at the same place,
/// what steps had left behind. Numbers are those of DrivenProblem.
struct Checkpoint {
    std::int64_t steps = 0, iterations = 0, evaluations = 0;
    double t = 0;
    std::vector<double> state = {};  ///< q, p, and the time where H depends on it
    std::vector<detail::Departure> departures = {};
    double motion = 0;  ///< sum and number of an EnergyOfMotion
    std::int64_t motions = 0;
    std::vector<EventMemory> events = {};
    std::vector<std::int64_t> counts = {};  ///< of events
    std::vector<double> reductions = {};    ///< as Reductions remembers them
    std::vector<std::int64_t> sizes =
        {};  ///< of the tables so far, in bytes; then of that of events
    std::vector<std::int64_t> rows = {};  ///< of the tables
};

/// The checkpoint as lines, of a run that the key tells from others, with the sum of their digits
/// at the end.
[[nodiscard]] std::string text(const Checkpoint& checkpoint, const std::string& key);

/// The last whole checkpoint in the text of a file, of a run with this key. Throws InputError, with
/// the place of the file's name, where there is none, and where it is of another run.
[[nodiscard]] Checkpoint last_checkpoint(const std::string& text, const std::string& key,
                                         const std::filesystem::path& file);

}  // namespace hvi::gen
