// Output files, which are written whole or not at all.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <string_view>

namespace hvi::gen {

/// Makes `text` the contents of the file. Whatever happens - a full disk, an interruption - the
/// file has its old contents or the new, and nothing else is left behind. Throws EnvironmentError.
void write_file(const std::filesystem::path& path, std::string_view text);

/// Makes an empty file for a program to write into. Its name was not in use before, not even by a
/// link. Throws EnvironmentError.
[[nodiscard]] std::filesystem::path new_file(const std::filesystem::path& directory);

/// Throws EnvironmentError when standard output is closed or full.
void write_standard_output(std::string_view text);

}  // namespace hvi::gen
