// A lock on a directory.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>

namespace hvi::gen {

/// A lock that all users of a directory share, or one holds alone. It ends with the process in any
/// case. Programs that are started do not hold it. Where the file system has no locks nobody ever
/// has the directory alone.
class DirectoryLock {
public:
    /// Holds nothing yet.
    explicit DirectoryLock(const std::filesystem::path& directory);
    ~DirectoryLock();
    DirectoryLock(const DirectoryLock&) = delete;
    DirectoryLock& operator=(const DirectoryLock&) = delete;

    /// Whether nobody else uses the directory, nor does until share().
    [[nodiscard]] bool try_alone();
    /// Waits for a process that has the directory alone.
    void share();

private:
    int descriptor_;
};

}  // namespace hvi::gen
