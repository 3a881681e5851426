// Decides when a run writes a checkpoint, and when it stops early.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

#include "generator/drive/trajectory.hpp"

namespace hvi::gen {

/// Lets SIGTERM ask the run to stop, and SIGUSR1 to write a checkpoint.
void heed_signals();

/// Whether the run is asked to stop.
[[nodiscard]] bool is_stopped();

/// Adds checkpoints to a file, by steps, by minutes and when a signal asks for one.
class CheckpointSaver {
public:
    /// Writes no checkpoints without wishes.
    explicit CheckpointSaver(const std::optional<CheckpointWishes>& wishes) : wishes_(wishes) {}

    /// Returns the number of steps to the next checkpoint.
    [[nodiscard]] std::int64_t ahead(std::int64_t taken) const;

    [[nodiscard]] bool is_due(std::int64_t taken) const;

    /// Throws std::runtime_error where the file cannot be written.
    void save(const Checkpoint& checkpoint);

private:
    using Clock = std::chrono::steady_clock;

    const std::optional<CheckpointWishes>& wishes_;
    Clock::time_point last_ = Clock::now();
};

}  // namespace hvi::gen
