// The picture of a study: values over two others.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

namespace hvi::gen {

struct MapPicture {
    std::string title;
    std::string x, y;  ///< names of the axes
    std::string z;     ///< the name of what colours show; empty where points are shown alone
    /// x, y and z of each row, row by row; x and y alone where there is no z.
    std::vector<double> values;
};

/// Draws SVG. Where x and y form a full rectangular grid it is an image, else points: of more than
/// 20,000 an image too, in which a pixel has the mean of its values, or is darker the more points
/// fall on it. Values that are not finite, or beyond 1e300, are grey; points with such x or y are
/// left out. Of a grid of more than 1000 points in a direction some are shown, evenly spaced.
/// Throws as gnuplot_svg() does, and EnvironmentError where memory is short.
[[nodiscard]] std::string draw(const MapPicture& picture);

}  // namespace hvi::gen
