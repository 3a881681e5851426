// Evenly spaced values: `--vary NAME=FROM:TO:COUNT`.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "generator/read/scene_times.hpp"

namespace hvi::gen {

/// Values of a name at equal distances.
struct Grid {
    std::string name;
    double from = 0, to = 0;
    std::int64_t count = 1;
    Place place;  ///< the place of the name

    /// Returns the value with this number, from 0 on: the first one is `from`, the last one `to`,
    /// and `from` where there is but one. Precondition: there are so many.
    [[nodiscard]] double at(std::int64_t k) const;
};

/// Reads NAME=FROM:TO:COUNT. FROM and TO may use parameters of the scene. Throws InputError, with
/// its place, where the text has another form, and where COUNT is no whole number from 1 to 10^9;
/// and as nearest_value() does.
[[nodiscard]] Grid grid(const Given& text, const SceneTimes& scene);

}  // namespace hvi::gen
