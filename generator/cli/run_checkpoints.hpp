// Checkpoints of a run: those that it writes, and the one that it resumes from.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/cli/options.hpp"
#include "generator/cli/run_summary.hpp"

namespace hvi::gen {

/// Returns a few digits that identify a run: its version of hvi-gen, stepper, parameters, step
/// size, events, and rows and columns of the table. The end of the run is left out, so that a
/// resumed run may go further.
[[nodiscard]] std::string key_of(const WishedRun& run, const TableWishes& table);

/// Returns the texts of events.
[[nodiscard]] std::string text_of(const std::vector<IndexedEvent>& events);

/// Returns the wished checkpoints: every ten minutes where no interval is given.
[[nodiscard]] std::optional<CheckpointWishes> wished_checkpoints(const CheckpointOptions& options,
                                                                 const std::string& key);

/// Returns the checkpoint that a run resumes from. Throws InputError as last_checkpoint() and
/// read_file() do.
[[nodiscard]] std::optional<Checkpoint> resumed_checkpoint(const CheckpointOptions& options,
                                                           const std::string& key);

}  // namespace hvi::gen
