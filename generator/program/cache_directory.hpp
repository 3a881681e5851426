// The directory of compiled programs.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "generator/program/directory_lock.hpp"
#include "generator/program/private_directory.hpp"

namespace hvi::gen {

/// The most bytes of kept programs.
constexpr std::uintmax_t most_bytes_of_cache = 256'000'000;

/// The directory hvi-gen/ in XDG_CACHE_HOME, else in .cache of HOME, else hvi-gen-UID/ in the
/// directory for temporary files. It is made where it is missing. Where others could put programs
/// there, which then would be run, a new directory among the temporary files takes its place. The
/// destructor removes that one; a warning reports it.
///
/// While the object lives no other process removes anything there. If no other process uses the
/// directory, the constructor tidies it: it removes unfinished programs, and the least recently
/// used ones beyond most_bytes_of_cache.
class CacheDirectory {
public:
    /// Throws EnvironmentError where no directory can be had that only the user can write to.
    CacheDirectory();

    /// Returns the path, absolute and without links.
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

    /// Removes all programs. Throws EnvironmentError where another process uses them.
    void clear();

private:
    std::filesystem::path path_;
    std::optional<FreshDirectory> fresh_;
    std::optional<DirectoryLock> lock_;
};

}  // namespace hvi::gen
