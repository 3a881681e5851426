// Many steps in a row.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <hvi/state.hpp>

namespace hvi {

/// What became of a run.
struct [[nodiscard]] Run {
    Status status;                ///< of the last step that was tried
    std::int64_t steps = 0;       ///< taken
    std::int64_t iterations = 0;  ///< of the solver, over all steps

    [[nodiscard]] bool ok() const { return status.ok(); }
};

/// Takes steps of size h from x at the time `start`, and calls observe(x, t) before the first and
/// after each of them. A step that fails ends the run, and x is where the last good one ended. The
/// times are start + k h, each rounded by itself, so that they do not drift.
template <class Stepper, class Observer>
Run integrate(Stepper& stepper, typename Stepper::State& x, typename Stepper::Scalar start,
              typename Stepper::Scalar h, std::int64_t steps, Observer&& observe) {
    using Scalar = typename Stepper::Scalar;
    const auto& unchanged = x;
    Run run;
    observe(unchanged, start);
    while (run.steps < steps) {
        run.status = stepper.step(x, h);
        run.iterations += run.status.iterations;
        if (!run.ok()) { return run; }
        ++run.steps;
        observe(unchanged, start + static_cast<Scalar>(run.steps) * h);
    }
    return run;
}

/// The same without an observer.
template <class Stepper>
Run integrate(Stepper& stepper, typename Stepper::State& x, typename Stepper::Scalar start,
              typename Stepper::Scalar h, std::int64_t steps) {
    return integrate(stepper, x, start, h, steps, [](const auto&, auto) {});
}

}  // namespace hvi
