// Evenly spaced values: `--vary NAME=FROM:TO:COUNT`.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "generator/read/scene_times.hpp"

namespace hvi::gen {

/// Numbers at equal distances: doubles nearest to the exact ones.
class GridValues {
public:
    /// Both ends are expressions of parameters of the scene.
    GridValues(std::string from, std::string to, std::int64_t count, SceneTimes scene);

    /// Returns the value with this number, from 0 on. Precondition: there are so many. Throws as
    /// nearest_value() does. One thread at a time may call it, since it keeps values.
    [[nodiscard]] double at(std::int64_t k) const;

private:
    [[nodiscard]] double value(std::int64_t k) const;

    std::string from_, to_;
    std::int64_t count_;
    SceneTimes scene_;
    mutable std::vector<std::optional<double>> kept_;  ///< empty where there are too many
};

/// Values of a name at equal distances.
struct Grid {
    std::string name;
    std::string ends;  ///< `0:2*pi`
    std::int64_t count = 1;
    std::shared_ptr<const GridValues> values;
    Place place;  ///< the place of the name

    /// Returns the value with this number, from 0 on: the first one is the first end, the last one
    /// the other, and the first where there is but one. Precondition and errors are those of
    /// GridValues.
    [[nodiscard]] double at(std::int64_t k) const { return values->at(k); }
};

/// Reads NAME=FROM:TO:COUNT. FROM and TO may use parameters of the scene. Throws InputError, with
/// its place, where the text has another form, and where COUNT is no whole number from 1 to 10^9;
/// and as nearest_value() does.
[[nodiscard]] Grid grid(const Given& text, const SceneTimes& scene);

}  // namespace hvi::gen
