// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/draw/pixels.hpp"

#include <algorithm>
#include <cmath>

namespace hvi::gen {

namespace {

std::vector<double> numbers_of(const std::vector<MapPoint>& points, double MapPoint::*which) {
    std::vector<double> result;
    for (const MapPoint& point : points) result.push_back(point.*which);
    return result;
}

/// Returns the pixel of a row or column that a number falls on. NOTE: halves, as a range may be
/// longer than the largest double.
std::size_t pixel_of(double number, const NumberRange& range, std::size_t count) {
    const double part = (number / 2 - range.from / 2) / (range.to / 2 - range.from / 2);
    const auto pixel = static_cast<std::size_t>(part * static_cast<double>(count));
    return std::min(pixel, count - 1);
}

}  // namespace

Pixels pixels(const std::vector<MapPoint>& points, std::size_t width, std::size_t height) {
    Pixels result{width,
                  height,
                  range_of(numbers_of(points, &MapPoint::x)),
                  range_of(numbers_of(points, &MapPoint::y)),
                  {},
                  {}};
    result.counts.resize(width * height);
    std::vector<double> finite(width * height), sums(width * height);
    for (const MapPoint& point : points) {
        const std::size_t place =
            pixel_of(point.y, result.y, height) * width + pixel_of(point.x, result.x, width);
        ++result.counts[place];
        if (!std::isfinite(point.z)) continue;
        ++finite[place];
        sums[place] += point.z;
    }
    for (std::size_t k = 0; k < sums.size(); ++k) result.means.push_back(sums[k] / finite[k]);
    return result;
}

}  // namespace hvi::gen
