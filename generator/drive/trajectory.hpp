// A trajectory of a stepper from its initial data: tables of states, events, and the departures of
// invariants.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "generator/drive/checkpoint.hpp"
#include "generator/drive/driven_event.hpp"
#include "generator/drive/row_file.hpp"
#include "generator/read/reductions.hpp"
#include "generator/read/table_columns.hpp"

namespace hvi::gen {

/// A table of a run.
struct TableWishes {
    std::int64_t every = 1;          ///< one row in so many steps, and the last
    std::vector<ColumnBox> columns;  ///< columns after the time: coordinates, momenta, invariants
    std::filesystem::path file;
    std::vector<double> times = {};  ///< times of rows; they replace `every`
    TableFormat format = TableFormat::csv;
    TableNumbers numbers = TableNumbers::doubles;
    std::vector<TableNote> notes = {};  ///< notes on the run
    /// Kinds of the columns by their names without an index: `momentum`.
    std::map<std::string, std::string, std::less<>> meanings = {};
};

/// Events, and their table.
struct EventWishes {
    std::vector<DrivenEvent> events;
    std::vector<ColumnBox> variables;  ///< columns of the table, by number among coordinates, then
                                       ///< momenta
    std::filesystem::path file;

    [[nodiscard]] bool has_rows() const {
        return std::any_of(events.begin(), events.end(),
                           [](const DrivenEvent& event) { return !event.event.is_kink; });
    }
};

/// The wishes for checkpoints of a run.
struct CheckpointWishes {
    std::filesystem::path file;  ///< the file for them
    std::string key;             ///< identifies the run
    std::int64_t every = 0;      ///< steps; 0 for none
    double minutes = 0;          ///< 0 for none
};

struct TrajectoryWishes {
    double h = 0;
    std::int64_t steps = 0;
    bool looks_at_rows = false;       ///< computes costly invariants at rows only
    std::vector<TableWishes> tables;  ///< at least one
    EventWishes events = {};
    std::optional<ScaledClock> clock = {};  ///< then `steps` is the most that are taken
    std::vector<Reduction> reductions = {};
    std::optional<CheckpointWishes> checkpoints = {};
    std::vector<ColumnBox> analysed = {};    ///< columns whose frequencies are reported
    std::optional<Checkpoint> resumed = {};  ///< the start; its tables exist so far
};

/// Takes the steps of DrivenProblem, and reports the outcome. Returns the exit status 0 also where
/// a step failed, and 3 where a file cannot be written.
[[nodiscard]] int take_trajectory(const TrajectoryWishes& wishes);

}  // namespace hvi::gen
