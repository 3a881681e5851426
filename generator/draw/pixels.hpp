// Many points as an image: what is at each of its pixels.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "generator/draw/map_point.hpp"
#include "generator/draw/palette.hpp"

namespace hvi::gen {

/// Points that fall on the pixels of an image, row by row from the lowest y.
struct Pixels {
    std::size_t width, height;
    NumberRange x, y;            ///< from the left edge to the right one, and from below
    std::vector<double> counts;  ///< of points
    std::vector<double> means;   ///< of finite values; NaN where there is none
};

/// Counts points. Precondition: x and y of each are shown.
[[nodiscard]] Pixels pixels(const std::vector<MapPoint>& points, std::size_t width,
                            std::size_t height);

}  // namespace hvi::gen
