// Where compiled programs are kept.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <optional>

#include "generator/program/private_directory.hpp"

namespace hvi::gen {

/// hvi-gen/ in XDG_CACHE_HOME, else in .cache of HOME, else hvi-gen-UID/ in the directory for
/// temporary files; made where it is missing. Where others could put programs there, which then
/// would be run, it is a new directory among the temporary files in its place, removed at the end
/// of its life; a warning says so.
class CacheDirectory {
public:
    /// Throws EnvironmentError where there is none to be had that is the user's alone.
    CacheDirectory();

    /// Absolute, and without links.
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
    std::optional<FreshDirectory> fresh_;
};

}  // namespace hvi::gen
