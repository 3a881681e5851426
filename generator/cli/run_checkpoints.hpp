// Checkpoints of a run: which it writes, and which it goes on from.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/cli/options.hpp"
#include "generator/cli/run_summary.hpp"

namespace hvi::gen {

/// What tells a run from others, in a few digits: the version of hvi-gen, the stepper, its
/// parameters, the size of its steps, events, and rows and columns of the table; not where it ends.
[[nodiscard]] std::string key_of(const WishedRun& run, const TableWishes& table);

/// The texts that events are made of.
[[nodiscard]] std::string text_of(const std::vector<IndexedEvent>& events);

/// The checkpoints that are wished for: each tenth minute where nothing else is said.
[[nodiscard]] std::optional<CheckpointWishes> wished_checkpoints(const CheckpointOptions& options,
                                                                 const std::string& key);

/// The checkpoint that a run goes on from. Throws InputError as last_checkpoint() and read_file()
/// do.
[[nodiscard]] std::optional<Checkpoint> resumed_checkpoint(const CheckpointOptions& options,
                                                           const std::string& key);

}  // namespace hvi::gen
