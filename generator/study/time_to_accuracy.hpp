// The cost of an accuracy, from runs that were measured.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/study/curves.hpp"

namespace hvi::gen {

/// The time that a method takes to an error of at most `accuracy`: that of a run which gets there,
/// or less, on the straight line of the logarithms between two runs next to each other on both
/// sides. Empty where no timed run gets there.
[[nodiscard]] std::optional<double> seconds_to(const WorkCurve& curve, double accuracy);

/// The method that is there first.
struct Quickest {
    std::string method;
    double seconds = 0;
    bool is_peer = false;  ///< of another library
};

/// All that get there, those of other libraries too, by rising time.
[[nodiscard]] std::vector<Quickest> in_order_of_time(const SceneReport& scene, double accuracy);

/// Empty where none gets there.
struct TimeToAccuracy {
    double accuracy = 0;
    std::optional<Quickest> own;
    std::optional<Quickest> peer;  ///< of another library
};

/// To 1e-4, 1e-8 and 1e-11.
[[nodiscard]] std::vector<TimeToAccuracy> times_to_accuracies(const SceneReport& scene);

}  // namespace hvi::gen
