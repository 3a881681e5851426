// Numbers that stand in a file of their own.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>

#include "generator/read/scene.hpp"

namespace hvi::gen {

/// Where values are: `{file = "start.csv", column = "x"}`.
struct ColumnFile {
    std::filesystem::path directory;  ///< of the scene
    std::string path;                 ///< as the scene has it
    std::optional<std::string> column;
    Place place;  ///< of all that, for errors
};

/// More values than these stay in their file.
constexpr std::size_t most_values_in_text = 256;

/// The values in a file: of a CSV file, whose first line has the names of columns, those of a
/// column, as they are written there; of an NPY file (numpy.save) of little-endian doubles, floats
/// or integers all, each as the shortest decimal that is that number. Blank lines and lines that
/// begin with # do not count. Where they are many they were only looked at, and are numbers all.
/// Throws InputError, with the line, for a file that is not there, is no regular one or is neither
/// of both, has no such column, or a row that is too short, and for what is no finite number of
/// many.
[[nodiscard]] std::variant<ValueList, ValueFile> values_in(const ColumnFile& file);

/// The same, read however many they are.
[[nodiscard]] ValueList all_values_in(const ColumnFile& file);

}  // namespace hvi::gen
