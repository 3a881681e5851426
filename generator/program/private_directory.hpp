// Directories that only the user can write to.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace hvi::gen {

/// Returns who else could replace the contents of a directory, as words for a message: a user other
/// than the system owns it or one above it, or others may write to it and remove files of others.
/// Missing paths, and those that are no directory, are passed over. Precondition: the path is
/// absolute, and no part of it is a link.
[[nodiscard]] std::optional<std::string> why_not_safe(const std::filesystem::path& directory);

/// Returns why a directory is not the user's alone: owned by the user, no link, of mode 0700.
[[nodiscard]] std::optional<std::string> why_not_private(const std::filesystem::path& directory);

/// Makes the directory, and those above it that are missing, for the user alone. Throws
/// EnvironmentError.
void make_private_directories(const std::filesystem::path& directory);

/// A new directory that only the user can use, with a name that nobody could guess. The destructor
/// removes it, with its contents, unless it is renamed.
class FreshDirectory {
public:
    /// Named `NAME-` and six letters. Throws EnvironmentError.
    FreshDirectory(const std::filesystem::path& above, const std::string& name);
    ~FreshDirectory();
    FreshDirectory(const FreshDirectory&) = delete;
    FreshDirectory& operator=(const FreshDirectory&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

}  // namespace hvi::gen
