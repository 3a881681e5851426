// The picture of a run: what it keeps and how well, and where it goes.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace hvi::gen {

/// A column of a table. NOTE: gnuplot finds none by a name with a comma in it, as in u[1,2].
struct TableColumn {
    std::size_t number;  ///< from 1 on
    std::string name;
};

/// Columns, one against the other.
using TableCurve = std::pair<TableColumn, TableColumn>;

/// Curves in the plane, of columns of a table; or none.
struct TableCurves {
    std::filesystem::path table;
    std::vector<TableCurve> curves;
};

/// The values of an index that are shown: the first one, and others that are `stride` apart.
struct ShownIndex {
    long first = 1, stride = 1;
    std::size_t count = 0;
};

/// A row of places over time, as an image: the columns of a table behind the time. Preconditions:
/// at least two places and two rows.
struct PlacesInTime {
    std::filesystem::path table;
    std::string name;
    ShownIndex places;
    std::size_t rows;    ///< that are shown, the first ones
    double time_of_row;  ///< from one row to the next
};

/// A field in the plane at the start and at the end, as images: a table of two rows, in which the
/// second index runs fastest. Precondition: at least two values of each index.
struct FieldAtEnds {
    std::filesystem::path table;
    std::string name;
    ShownIndex first, second;
};

/// Where a run goes.
using View = std::variant<TableCurves, PlacesInTime, FieldAtEnds>;

struct TrajectoryPicture {
    /// A column and its value in the first row, from which it should not depart.
    struct Kept {
        TableColumn column;
        double start;
    };

    std::string title;
    double until = 0;  ///< the last time
    /// A row of names, and rows of numbers, the first one the time. Other tables are beside it.
    std::filesystem::path table;
    std::vector<Kept> kept;
    std::vector<TableColumn> columns;  ///< shown over time, where the view is no image
    std::string title_of_columns = "positions";
    View view;
};

/// Draws SVG. Throws as gnuplot_svg() does.
[[nodiscard]] std::string draw(const TrajectoryPicture& picture);

/// Pairs of columns to draw one against the other: q against p for one degree of freedom; else
/// positions, where there are bodies those of each: x[i] against y[i]. None where a picture knows
/// of neither two coordinates nor one and a momentum.
[[nodiscard]] std::vector<TableCurve> curves_of(const std::vector<TableColumn>& coordinates,
                                                const std::vector<TableColumn>& momenta);

}  // namespace hvi::gen
