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

/// What is to become of a run.
struct RunCase {
    Scene scene;
    std::string what;
    double h = 0, until = 0;
    std::string expected;
    /// Precondition of the call: the run has an end, of a state of as many numbers as expected.
    std::function<bool(const EventfulMeasurement&)> agrees;
    int least_order = 1;             ///< of methods of which that is expected
    std::vector<double> times = {};  ///< at which it looks at the first coordinate
};

/// A scale of the time with which there is no run.
struct RefusedScale {
    Scene scene;
    std::string what;
    std::string words;  ///< of the reason
};

/// A jump that is said to be symplectic.
struct ClaimedJump {
    Scene scene;
    std::string what;
    bool is_symplectic;
};

[[nodiscard]] std::vector<RunCase> runs_in_scaled_time();
[[nodiscard]] std::vector<RunCase> runs_with_events();
[[nodiscard]] std::vector<RefusedScale> refused_scales();
[[nodiscard]] std::vector<ClaimedJump> claimed_jumps();

/// Checkpoints that are written and read, of no run.
[[nodiscard]] EdgeCheck numbers_of_checkpoint();
[[nodiscard]] EdgeCheck cut_checkpoint();

}  // namespace hvi::gen
