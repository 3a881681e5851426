// Points that form a full rectangular grid.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "generator/draw/map_point.hpp"

namespace hvi::gen {

/// Evenly spaced coordinates and a value at each point of their grid, row by row: x runs fastest.
struct FullGrid {
    std::vector<double> x, y;  ///< ascending
    std::vector<double> values;
};

/// Returns the grid of points, in whatever order they come. Empty where a point of the grid is
/// missing or comes twice, where coordinates are not evenly spaced, and where there are fewer than
/// two of x or of y. Precondition: x and y of each are shown.
[[nodiscard]] std::optional<FullGrid> full_grid(const std::vector<MapPoint>& points);

/// Returns a grid with at most so many x and y: some of them, evenly spaced.
[[nodiscard]] FullGrid thinned(const FullGrid& grid, std::size_t most);

}  // namespace hvi::gen
