// Directories that nobody but the user can put anything into.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace hvi::gen {

/// Who else could put something in the place of what is in there, as words for a message: where the
/// directory, or one above it, belongs to another user than the system's, or others may write to it
/// and remove what is not theirs. What is not there, or no directory, is passed over. Precondition:
/// the path is absolute, and no part of it is a link.
[[nodiscard]] std::optional<std::string> why_not_safe(const std::filesystem::path& directory);

/// The same for a directory that is to be the user's alone: its own, no link, of mode 0700.
[[nodiscard]] std::optional<std::string> why_not_private(const std::filesystem::path& directory);

/// Makes the directory, and those above it that are missing, for the user alone. Throws
/// EnvironmentError.
void make_private_directories(const std::filesystem::path& directory);

/// A new directory that is the user's alone, of a name that nobody could guess. Removed, with what
/// is in it, at the end of its life unless renamed.
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
