// Results go out whole or not at all.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <string_view>

namespace hvi::gen {

/// Makes `text` the contents of the file. Whatever happens on the way - a full disk, an
/// interruption - the file holds its old contents or the new, and nothing else is left behind.
/// Throws EnvironmentError.
void write_file(const std::filesystem::path& path, std::string_view text);

/// An empty file in the directory, of a name that nothing had before, not even a link that leads
/// elsewhere: for a program that writes into it. Throws EnvironmentError.
[[nodiscard]] std::filesystem::path new_file(const std::filesystem::path& directory);

/// Throws EnvironmentError when it is closed or full.
void write_standard_output(std::string_view text);

}  // namespace hvi::gen
