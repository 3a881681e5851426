// Numbers in a file of their own.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>

#include "generator/read/scene.hpp"

namespace hvi::gen {

/// A reference to values in a file: `{file = "start.csv", column = "x"}`.
struct ColumnFile {
    std::filesystem::path directory;  ///< the scene's directory
    std::string path;                 ///< the path in the scene file
    std::optional<std::string> column;
    Place place;  ///< the place of the whole reference, for errors
};

/// More values than these stay in their file.
constexpr std::size_t most_values_in_text = 256;

/// Reads the values in a file. In a CSV file, whose first line has the names of columns, they are
/// the values of a column, as they are written there. An NPY file (numpy.save) has little-endian
/// doubles, floats or integers; each is read as the shortest decimal that is that number. Blank
/// lines and lines that begin with # do not count. Where there are more than `most_values_in_text`,
/// the values are only checked to be numbers and stay in the file. Throws InputError, with the
/// line, for a file that does not exist, is not a regular file or has neither format, for a missing
/// column, for a row that is too short, and, among many values, for one that is no finite number.
[[nodiscard]] std::variant<ValueList, ValueFile> values_in(const ColumnFile& file);

/// Reads all values in a file, however many they are. Throws as values_in() does.
[[nodiscard]] ValueList all_values_in(const ColumnFile& file);

}  // namespace hvi::gen
