// The picture of a run: what it keeps and how well, and where it goes.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace hvi::gen {

/// A column of a table. NOTE: gnuplot finds none by a name with a comma in it, as in u[1,2].
struct TableColumn {
    std::size_t number;  ///< from 1 on
    std::string name;
};

/// Columns, one against the other.
using TableCurve = std::pair<TableColumn, TableColumn>;

struct TrajectoryPicture {
    /// A column and its value in the first row, from which it should not depart.
    struct Kept {
        TableColumn column;
        double start;
    };

    std::string title;
    double until = 0;             ///< the last time
    std::filesystem::path table;  ///< a row of names, and rows of numbers, the first one the time
    std::vector<Kept> kept;
    std::vector<TableColumn> columns;  ///< shown over time where nothing is kept
    std::string title_of_columns = "positions";
    std::vector<TableCurve> curves;  ///< or none
};

/// As SVG. Throws as gnuplot_svg() does.
[[nodiscard]] std::string draw(const TrajectoryPicture& picture);

/// What to draw one against the other: q against p for one degree of freedom; else positions, those
/// of each body where there are bodies: x[i] against y[i]. Nothing where a picture knows of neither
/// two coordinates nor one and a momentum.
[[nodiscard]] std::vector<TableCurve> curves_of(const std::vector<TableColumn>& coordinates,
                                                const std::vector<TableColumn>& momenta);

}  // namespace hvi::gen
