// Reading a whole file that the user named.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace hvi::gen {

/// Returns the bytes of a file. Throws InputError when the file does not exist, cannot be read, or
/// has more than `limit` bytes; no more than that is read.
[[nodiscard]] std::string read_file(const std::filesystem::path& path, std::size_t limit);

/// Returns the last part of a file's name, as a word of a command line in a comment: in quotes
/// where needed, and without characters that a shell or a compiler would act on.
[[nodiscard]] std::string quoted_file_name(const std::string& path);

}  // namespace hvi::gen
