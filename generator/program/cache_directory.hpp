// Where compiled programs are kept.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "generator/program/directory_lock.hpp"
#include "generator/program/private_directory.hpp"

namespace hvi::gen {

/// That programs may have which are kept.
constexpr std::uintmax_t most_bytes_of_cache = 256'000'000;

/// hvi-gen/ in XDG_CACHE_HOME, else in .cache of HOME, else hvi-gen-UID/ in the directory for
/// temporary files; made where it is missing. Where others could put programs there, which then
/// would be run, it is a new directory among the temporary files in its place, removed at the end
/// of its life; a warning says so.
///
/// While it lives no other process removes anything there. Where none lives in another process it
/// begins with tidying: what was left unfinished goes, and beyond so many bytes the least recently
/// used programs.
class CacheDirectory {
public:
    /// Throws EnvironmentError where there is none to be had that is the user's alone.
    CacheDirectory();

    /// Absolute, and without links.
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

    /// Removes all programs. Throws EnvironmentError where another process uses them.
    void clear();

private:
    std::filesystem::path path_;
    std::optional<FreshDirectory> fresh_;
    std::optional<DirectoryLock> lock_;
};

}  // namespace hvi::gen
