// How much of a run a picture shows before lines run into each other, and it is but a bar.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <utility>
#include <vector>

namespace hvi::gen {

/// Columns of a table, which are counted from 1 on, without its first row and without lines that
/// begin with #. What is no number is NaN. Throws EnvironmentError where the table cannot be read.
[[nodiscard]] std::vector<std::vector<double>>
read_columns(const std::filesystem::path& table, const std::vector<std::size_t>& numbers);

/// The number of first values with at most so many turning points: places from which the curve of
/// them goes back by more than `least`. All where there are no more.
[[nodiscard]] std::size_t rows_with_turns(const std::vector<double>& values, double least,
                                          std::size_t most);

/// The range and the mean of a curve in each of some parts of it.
struct Band {
    std::vector<double> x, least, most, mean;  ///< `x`: the middle of the part
};

/// The band of values over x in so many parts, whose numbers of rows differ by at most one. Values
/// that are not finite do not count, and a part without others is left out. Precondition: there are
/// as many rows as parts.
[[nodiscard]] Band band(const std::vector<double>& x, const std::vector<double>& values,
                        std::size_t parts);

/// The distance between the least and the largest finite value of all columns; 0 where there is
/// none.
[[nodiscard]] double extent(const std::vector<std::vector<double>>& columns);

/// Two columns, one against the other.
using PlaneCurve = std::pair<std::vector<double>, std::vector<double>>;

/// The number of first rows whose curves leave a fair part of the picture empty: all, unless these
/// cross more than three fifths of its 50 times 50 cells; then those that cross a quarter.
[[nodiscard]] std::size_t rows_with_room(const std::vector<PlaneCurve>& curves);

}  // namespace hvi::gen
