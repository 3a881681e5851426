// Who uses a directory at a time.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>

namespace hvi::gen {

/// Held by all who use a directory, or by one who has it alone; gone with the process, however that
/// ends. Programs that are started do not hold it. Where the file system has no locks nobody ever
/// has the directory alone.
class DirectoryLock {
public:
    /// Holds nothing yet.
    explicit DirectoryLock(const std::filesystem::path& directory);
    ~DirectoryLock();
    DirectoryLock(const DirectoryLock&) = delete;
    DirectoryLock& operator=(const DirectoryLock&) = delete;

    /// Whether nobody else uses it, nor does until share().
    [[nodiscard]] bool try_alone();
    /// Waits for who has it alone.
    void share();

private:
    int descriptor_;
};

}  // namespace hvi::gen
