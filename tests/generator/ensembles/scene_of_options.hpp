// A scene whose parameters texts of options may use.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/read/scene_times.hpp"

namespace hvi::gen {

/// With w = 1/3 and m[2] = sqrt(2).
inline SceneTimes scene_of_options() {
    return times_of(scene_from_toml({"scene.toml", R"toml(
coordinates = ["q"]
momenta = ["p"]
hamiltonian = "p^2/2 + w*q^2"
[parameters]
w = "1/3"
m = [1, "sqrt(2)"]
[initial]
q = 1
p = 0
)toml"}));
}

}  // namespace hvi::gen
