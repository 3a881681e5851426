// A run of a scene of any size, whose invariants are computed now and then.
// SPDX-License-Identifier: MIT
//
// For `Problem` see departure.hpp.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>

#include <driver/cost.hpp>
#include <driver/departure.hpp>
#include <hvi/detail/trajectories/take.hpp>

namespace hvi::driver {

/// A run from the start. NOTE: computing invariants costs as much as a step.
template <class Problem>
class LargeRun {
public:
    LargeRun(double h, std::int64_t steps) : h_(h), steps_(steps) {}

    /// Takes the steps in `parts` parts, as equal as may be, or until one fails; `see(t)` is called
    /// at the end of each part.
    template <class See>
    void run(std::int64_t parts, See see) {
        const std::int64_t count = std::min(parts, steps_);
        for (std::int64_t part = 1; part <= count && outcome_.ok(); ++part) {
            // NOTE: the product of very many steps with a part would be beyond integers.
            const std::int64_t end =
                steps_ / count * part + steps_ % count * part / count - outcome_.steps;
            const auto start = std::chrono::steady_clock::now();
            const Run taken = detail::take(stepper_, x_, h_, end);
            seconds_ +=
                std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
            outcome_.steps += taken.steps;
            outcome_.iterations += taken.iterations;
            outcome_.status = taken.status.message();
            invariants_.see(stepper_, x_);
            see(h_ * static_cast<double>(outcome_.steps));
        }
        outcome_.evaluations = static_cast<std::int64_t>(stepper_.evaluations());
    }

    [[nodiscard]] const Outcome& outcome() const { return outcome_; }
    [[nodiscard]] const auto& state() const { return x_; }
    [[nodiscard]] const Invariants<Problem>& invariants() const { return invariants_; }

    /// Returns the time of the steps alone.
    [[nodiscard]] double seconds() const { return seconds_; }

private:
    double h_;
    std::int64_t steps_;
    typename Problem::Stepper stepper_ = Problem::stepper();
    typename Problem::Stepper::State x_ = Problem::initial();
    Invariants<Problem> invariants_{stepper_, x_};
    Outcome outcome_;
    double seconds_ = 0;
};

}  // namespace hvi::driver
