// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/draw/full_grid.hpp"

#include <algorithm>
#include <cmath>

namespace hvi::gen {

namespace {

/// Returns the values of a coordinate, ascending, each of them once.
std::vector<double> coordinates(const std::vector<MapPoint>& points, double MapPoint::*which) {
    std::vector<double> result;
    for (const MapPoint& point : points) result.push_back(point.*which);
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
}

bool is_even(const std::vector<double>& coordinates) {
    constexpr double least_of_pixel = 0.01;
    const auto gaps = static_cast<double>(coordinates.size() - 1);
    const double first = coordinates.front(), distance = (coordinates.back() - first) / gaps;
    for (std::size_t k = 0; k < coordinates.size(); ++k)
        if (std::abs(coordinates[k] - first - static_cast<double>(k) * distance) >
            least_of_pixel * distance)
            return false;
    return true;
}

std::size_t place_of(double value, const std::vector<double>& coordinates) {
    return static_cast<std::size_t>(
        std::lower_bound(coordinates.begin(), coordinates.end(), value) - coordinates.begin());
}

}  // namespace

std::optional<FullGrid> full_grid(const std::vector<MapPoint>& points) {
    FullGrid grid{coordinates(points, &MapPoint::x), coordinates(points, &MapPoint::y), {}};
    const std::size_t width = grid.x.size();
    if (width < 2 || grid.y.size() < 2 || width * grid.y.size() != points.size()) return {};
    if (!is_even(grid.x) || !is_even(grid.y)) return {};
    std::vector<bool> is_there(points.size());
    grid.values.resize(points.size());
    for (const MapPoint& point : points) {
        const std::size_t place = place_of(point.y, grid.y) * width + place_of(point.x, grid.x);
        if (is_there[place]) return {};
        is_there[place] = true;
        grid.values[place] = point.z;
    }
    return grid;
}

FullGrid thinned(const FullGrid& grid, std::size_t most) {
    const auto stride = [&](std::size_t count) { return (count + most - 1) / most; };
    const std::size_t stride_x = stride(grid.x.size()), stride_y = stride(grid.y.size());
    FullGrid result;
    for (std::size_t i = 0; i < grid.x.size(); i += stride_x) result.x.push_back(grid.x[i]);
    for (std::size_t j = 0; j < grid.y.size(); j += stride_y) {
        result.y.push_back(grid.y[j]);
        for (std::size_t i = 0; i < grid.x.size(); i += stride_x)
            result.values.push_back(grid.values[j * grid.x.size() + i]);
    }
    return result;
}

}  // namespace hvi::gen
