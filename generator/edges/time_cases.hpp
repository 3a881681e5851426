// Cases of the chapter on events and scaled time.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "generator/edges/edges.hpp"
#include "generator/read/scene.hpp"
#include "generator/simulate/eventful_run.hpp"

namespace hvi::gen {

/// A run with its expected result.
struct RunCase {
    Scene scene;
    std::string what;
    double h = 0, until = 0;
    std::string expected;
    /// Precondition of the call: the run has an end, whose state has as many numbers as expected.
    std::function<bool(const EventfulMeasurement&)> agrees;
    int least_order = 1;             ///< the least order of methods that must pass
    std::vector<double> times = {};  ///< times at which the first coordinate is checked
};

/// A scale of time that is refused.
struct RefusedScale {
    Scene scene;
    std::string what;
    std::string words;  ///< words of the reason
};

/// A jump that is claimed to be symplectic.
struct ClaimedJump {
    Scene scene;
    std::string what;
    bool is_symplectic;
};

[[nodiscard]] std::vector<RunCase> runs_in_scaled_time();
[[nodiscard]] std::vector<RunCase> runs_with_events();
[[nodiscard]] std::vector<RefusedScale> refused_scales();
[[nodiscard]] std::vector<ClaimedJump> claimed_jumps();

/// Check checkpoints that are written and read without a run.
[[nodiscard]] EdgeCheck numbers_of_checkpoint();
[[nodiscard]] EdgeCheck cut_checkpoint();

}  // namespace hvi::gen
