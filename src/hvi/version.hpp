// The version of the runtime, and which generated headers it serves.
// SPDX-License-Identifier: MIT
#pragma once

namespace hvi {

inline constexpr int version_major = 0;
inline constexpr int version_minor = 1;
inline constexpr int version_patch = 0;

/// Generated headers name the format of their calls into the runtime; these are understood. In 3
/// there came methods with a parameter, in 4 stages without momenta, the time, steps as shears, and
/// the curve of a step, in 5 the solvers and vectors of scenes, and steps as products with a
/// matrix, in 6 stages in lanes, in 7 trajectories in lanes, in 8 joint slopes, and starting values
/// of two steps, in 9 the time of trajectories, explicit ones as sums, and times that end, in 10
/// weights of kicks and drifts.
inline constexpr int oldest_format = 2;
inline constexpr int newest_format = 10;

[[nodiscard]] constexpr bool supports_format(int format) {
    return oldest_format <= format && format <= newest_format;
}

}  // namespace hvi
