// Lines of columns of a table, as commands of gnuplot.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace hvi::gen {

// Told apart by colour and, in print, by the length of their dashes.
inline constexpr const char* line_styles = R"(
set datafile separator comma
set datafile commentschars '#'
set style line 1 linecolor rgb '#00508c' linewidth 1.2
set style line 2 linecolor rgb '#c83200' linewidth 1.2 dashtype '-'
set style line 3 linecolor rgb '#3c7828' linewidth 1.2 dashtype '.-'
set style line 4 linecolor rgb '#784696' linewidth 1.2 dashtype '.'
set style line 5 linecolor rgb '#646464' linewidth 1.2 dashtype '..-'
set grid linecolor rgb '#d8d8d8'
set border linecolor rgb '#505050'
)";
inline constexpr std::size_t style_count = 5;
inline constexpr std::size_t time_column = 1;
inline constexpr double least_swing = 0.05;  ///< that is seen to be one, of the height of a panel

/// A column over another, less a constant, in units of `unit`.
struct Line {
    std::size_t x, y;
    double less = 0;
    std::string name;
    double unit = 1;
};

/// The first rows of a table, and the time of the last of these.
struct FirstRows {
    std::size_t count = 0;
    double until = 0;
    bool are_all = true;
};

/// Precondition: the times are those of a table.
[[nodiscard]] FirstRows first_rows(const std::vector<double>& times, std::size_t count);

/// The name of a table in the directory that gnuplot runs in.
[[nodiscard]] std::string quoted_name(const std::filesystem::path& table);

/// Sets the label of an axis that shows the time.
[[nodiscard]] std::string time_label(const std::string& text);

/// Sets the place of the names of so many lines; of one alone the title of its panel says it.
[[nodiscard]] std::string key_for(std::size_t lines);

/// The part of `plot` that draws a line in the k-th style. NOTE: what is no finite number is not
/// drawn.
[[nodiscard]] std::string drawn_line(const std::filesystem::path& table, const Line& line,
                                     std::size_t k, const FirstRows& rows = {});

/// Plots lines in one panel.
[[nodiscard]] std::string plot(const std::filesystem::path& table, const std::vector<Line>& lines,
                               const FirstRows& rows);

}  // namespace hvi::gen
