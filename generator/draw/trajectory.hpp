// The picture of a run: what it keeps and how well, and where it goes.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace hvi::gen {

struct TrajectoryPicture {
    /// A column and its value in the first row, from which it should not depart.
    struct Kept {
        std::string column;
        double start;
    };

    std::string title;
    double until = 0;             ///< the last time
    std::filesystem::path table;  ///< a row of names, and rows of numbers, the first one the time
    std::vector<Kept> kept;
    std::vector<std::string> columns;  ///< shown over time where nothing is kept
    std::vector<std::pair<std::string, std::string>> curves;  ///< columns, one against the other
};

/// As SVG. Throws as gnuplot_svg() does.
[[nodiscard]] std::string draw(const TrajectoryPicture& picture);

/// What to draw one against the other: q against p for one degree of freedom; else positions, those
/// of each body where there are bodies: x[i] against y[i].
[[nodiscard]] std::vector<std::pair<std::string, std::string>>
curves_of(const std::vector<std::string>& coordinates, const std::vector<std::string>& momenta);

}  // namespace hvi::gen
