// The picture that decides: what a digit costs.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace hvi::gen {

/// Errors against what they cost, a curve for each method.
struct WorkPicture {
    struct Curve {
        std::string name;
        std::vector<std::pair<double, double>> points;  ///< cost and error, both above 0
    };

    std::string title;
    std::string cost;  ///< the name of that axis
    std::vector<Curve> curves;
};

/// As SVG, both axes logarithmic; curves are told apart by colour, dashes and marks. Throws as
/// gnuplot_svg() does.
[[nodiscard]] std::string draw(const WorkPicture& picture);

}  // namespace hvi::gen
