// Laying out text for a terminal: tables of cells, and long lines broken in good places.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace hvi::gen {

constexpr std::size_t terminal_columns = 80;

using Lines = std::vector<std::string>;
using Cells = std::vector<std::vector<std::string>>;

/// A table with a head column before the bar and a last row below the line:
///
///      c   | A
///      0   | 0    0
///      1   | 1/2  1/2
///     -----+----------
///      b   | 1/2  1/2
///
/// Columns are as wide as their widest cell; where one has a cell with a minus, the others are
/// indented by one. Precondition: as many heads as rows, and rows of the last row's length.
struct Table {
    std::string corner;
    std::string title;
    std::vector<std::string> heads;
    Cells rows;
    std::string last_head;
    std::vector<std::string> last_row;
};

/// Returns the lines of a table, without blanks at their ends.
[[nodiscard]] Lines table_lines(const Table& table);

/// Returns the length of the longest line.
[[nodiscard]] std::size_t width(const Lines& lines);

/// Puts two blocks side by side, with a gap.
[[nodiscard]] Lines beside(const Lines& left, const Lines& right);

/// Breaks `head` and `text` into lines where they would pass the last column of the terminal:
/// before a sign, or else at an operator or after a comma. Later lines are indented by the head's
/// length. A piece that cannot be broken makes its line longer.
[[nodiscard]] Lines wrapped(const std::string& head, const std::string& text);

}  // namespace hvi::gen
