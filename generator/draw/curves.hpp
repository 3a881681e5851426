// Curves to be compared, on logarithmic axes.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace hvi::gen {

struct CurvesPicture {
    struct Curve {
        std::string name;
        std::vector<std::pair<double, double>> points;  ///< finite, above 0 on a logarithmic axis
        bool is_aside = false;  ///< thin and grey: others are compared with it
        std::vector<std::pair<double, double>> ringed = {};  ///< points with a ring around
    };

    std::string title;
    std::string x, y;  ///< what the axes are; y is logarithmic
    bool x_is_logarithmic = true;
    bool has_marks = true;  ///< at each point, else a line alone
    std::vector<Curve> curves;
    std::string about_rings = {};  ///< a name for the points that have one
};

/// Draws SVG of a width that a narrow screen shows without making its text small, and a height that
/// leaves room for the names of all curves below. Curves are told apart by colour, dashes and
/// marks. Throws as gnuplot_svg() does.
[[nodiscard]] std::string draw(const CurvesPicture& picture);

}  // namespace hvi::gen
