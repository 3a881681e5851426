// Departures of invariants over time.
// SPDX-License-Identifier: MIT
//
// For `Problem` see departure.hpp.
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

/// Writes the time and the largest departure of each invariant in each of `samples` parts of a run.
template <class Problem>
class DepartureSamples {
public:
    DepartureSamples(double until, std::int64_t parts) : until_(until), parts_(parts) {}

    /// Adds the invariants at t. Precondition: they are computed at t.
    void see(double t, const Invariants<Problem>& invariants) {
        for (std::size_t i = 0; i < largest_.size(); ++i) {
            largest_[i] = std::max(largest_[i], std::abs(invariants.departures()[i].last));
        }
        const double part = t / until_ * static_cast<double>(parts_);
        // NOTE: rounding may make t a little less than the end of a part.
        if (part + 1e-6 < static_cast<double>(next_)) { return; }
        next_ = static_cast<std::int64_t>(part + 1e-6) + 1;
        say("time", t);
        for (double& value : largest_) {
            say("departure", value);
            value = 0;
        }
    }

private:
    double until_;
    std::int64_t parts_, next_ = 1;
    std::vector<double> largest_ = std::vector<double>(Problem::invariants().size());
};

/// The command `departures H STEPS SAMPLES`: a run with so many samples. Returns the status that
/// trajectory() returns.
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
    DepartureSamples<Problem> all(h * static_cast<double>(steps), samples);
    for (std::int64_t taken = 1; taken <= steps; ++taken) {
        if (!stepper.step(x, h).ok()) { return 0; }
        invariants.see(stepper, x);
        all.see(static_cast<double>(taken) * h, invariants);
    }
    return 0;
}

}  // namespace hvi::driver
