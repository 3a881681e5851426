// End, cost and time of a run.
// SPDX-License-Identifier: MIT
//
// For `Problem` see departure.hpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include <driver/answer.hpp>
#include <driver/cost.hpp>
#include <driver/departure.hpp>
#include <hvi/detail/trajectories/flat.hpp>
#include <hvi/detail/trajectories/take.hpp>
#include <hvi/state.hpp>

namespace hvi::driver {

/// Writes how fast the state moves at the end, to a few digits, by a short step.
template <class Problem, class State>
void tell_velocity(const State& x, double h) {
    auto stepper = Problem::stepper();
    State y = x;
    const double shorter = h / (1 << 20);
    static_cast<void>(stepper.step(y, shorter));
    const auto& from = detail::flat<typename Problem::Stepper>(x);
    const auto& to = detail::flat<typename Problem::Stepper>(y);
    const auto tell = [&](const auto& a, const auto& b) {
        for (std::size_t k = 0; k < a.size(); ++k) { say("velocity", (b[k] - a[k]) / shorter); }
    };
    tell(from.q, to.q);
    tell(from.p, to.p);
}

/// The command `measure H STEPS SECONDS`: one run with its invariants, and timed repetitions, over
/// so many seconds and at least three. Returns the status that trajectory() returns.
template <class Problem>
int measure(const std::vector<std::string_view>& words) {
    double h = 0, seconds = 0;
    std::int64_t steps = 0;
    const bool is_right = words.size() == 3 && read(words[0], h) && read(words[1], steps) &&
                          read(words[2], seconds) && steps >= 0;
    if (!is_right) { return 2; }

    auto stepper = Problem::stepper();
    auto x = Problem::initial();
    Invariants<Problem> invariants(stepper, x);
    Outcome outcome;
    const Run run = invariants.take(stepper, x, h, steps);
    outcome.steps = run.steps;
    outcome.iterations = run.iterations;
    outcome.status = run.status.message();
    outcome.evaluations = stepper.evaluations();
    tell(outcome, invariants, detail::flat<typename Problem::Stepper>(x));
    tell_velocity<Problem>(x, h);
    if (!outcome.ok() || seconds <= 0) { return 0; }
    tell_time(seconds, [&] {
        return [stepper = Problem::stepper(), x = Problem::initial(), h, steps]() mutable {
            return detail::take(stepper, x, h, steps).ok();
        };
    });
    return 0;
}

}  // namespace hvi::driver
