// How what a run should keep departs over time.
// SPDX-License-Identifier: MIT
//
// For `Problem` see main.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include <driver/answer.hpp>
#include <driver/departure.hpp>
#include <hvi/state.hpp>

namespace hvi::driver {

/// The command `departures H STEPS SAMPLES`: says the time and the largest departure of each
/// invariant in so many parts of the run, of steps in a row. As for trajectory().
template <class Problem>
int departures(const std::vector<std::string_view>& words) {
    double h = 0;
    std::int64_t steps = 0, samples = 0;
    const bool is_right = words.size() == 3 && read(words[0], h) && read(words[1], steps) &&
                          read(words[2], samples) && steps >= 0 && samples >= 1;
    if (!is_right) { return 2; }

    auto stepper = Problem::stepper();
    auto x = Problem::initial();
    Invariants<Problem> invariants(stepper, x);
    std::vector<double> largest(Problem::invariants.size());
    const std::int64_t each = (steps + samples - 1) / samples;
    for (std::int64_t taken = 1; taken <= steps; ++taken) {
        if (!stepper.step(x, h).ok()) { return 0; }
        invariants.see(stepper, x);
        for (std::size_t i = 0; i < largest.size(); ++i) {
            largest[i] = std::max(largest[i], std::abs(invariants.departures()[i].last));
        }
        if (taken % each != 0 && taken != steps) { continue; }
        say("time", static_cast<double>(taken) * h);
        for (double& value : largest) {
            say("departure", value);
            value = 0;
        }
    }
    return 0;
}

}  // namespace hvi::driver
