// Content of a directory of compiled programs, and removal of old ones.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace hvi::gen {

struct CacheContent {
    struct Program {
        std::filesystem::path directory;
        std::uintmax_t bytes = 0;
        std::filesystem::file_time_type used;
    };
    std::vector<Program> programs;                  ///< the least recently used first
    std::vector<std::filesystem::path> unfinished;  ///< being made, or left by a killed process

    [[nodiscard]] std::uintmax_t bytes() const;
};

/// Returns the content. Files of others are passed over.
[[nodiscard]] CacheContent content_of(const std::filesystem::path& cache);

/// Marks a program as used now. Its directory has a file `key`, whose time is set.
void mark_used(const std::filesystem::path& program_directory);

/// Removes unfinished programs, then the least recently used ones, until the rest has at most
/// `most_bytes` bytes. Precondition: no other process uses the directory.
void tidy(const std::filesystem::path& cache, std::uintmax_t most_bytes);

}  // namespace hvi::gen
