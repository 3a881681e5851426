// A point of a picture with a value.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cmath>
#include <limits>

namespace hvi::gen {

/// Whether a number has a place in a picture. NOTE: gnuplot fails where distances overflow.
[[nodiscard]] inline bool is_shown(double number) { return std::abs(number) < 1e300; }

struct MapPoint {
    double x = 0, y = 0;
    double z = std::numeric_limits<double>::quiet_NaN();  ///< of a point without a value NaN
};

}  // namespace hvi::gen
