// Chunks that workers take, one after the other.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "generator/ensembles/study.hpp"

namespace hvi::gen {

/// Claims chunks of a study by lock files. The worker that makes the file has the chunk, as long as
/// it touches the file at regular times: by SIGALRM, which one object in a process uses. A lock
/// whose worker has died on this machine, or that was not touched for minutes, counts no more.
/// NOTE: two workers may yet compute one chunk, where clocks or file systems are odd. They write
/// the same bytes.
class LockClaims {
public:
    /// Begins at a place of its own, so that workers seldom meet. Precondition: begin(study).
    explicit LockClaims(const Study& study);
    ~LockClaims();
    LockClaims(const LockClaims&) = delete;
    LockClaims& operator=(const LockClaims&) = delete;

    /// Releases the last chunk, and claims another one; nothing where there is none. Throws
    /// EnvironmentError.
    [[nodiscard]] std::optional<std::int64_t> next();

private:
    [[nodiscard]] bool was_done(std::int64_t chunk);
    [[nodiscard]] bool is_old(const std::filesystem::path& lock);
    [[nodiscard]] bool claim(std::int64_t chunk);
    void release();

    const Study& study_;
    std::int64_t first_, looked_at_ = 0;
    std::optional<std::int64_t> claimed_;
    std::optional<std::int64_t> listed_;  ///< the directory of `done_`
    std::vector<bool> done_;
    std::optional<long> ahead_;  ///< of the clock of the file system, in seconds
};

}  // namespace hvi::gen
