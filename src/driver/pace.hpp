// Time of a step.
// SPDX-License-Identifier: MIT
//
// For `Problem` see departure.hpp.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>

#include <hvi/detail/trajectories/take.hpp>
#include <hvi/integrate.hpp>

namespace hvi::driver {

/// When the invariants of a run are computed.
enum class Watch {
    steps,  ///< after every step
    rows,   ///< where a row is written: they cost as much as a step
};

/// Returns the seconds that a step takes without looks at the invariants, over at most half a
/// second from the start of the run. Zero where no step can be taken.
template <class Problem>
double seconds_of_step(Watch watch, double h, std::int64_t steps) {
    using Clock = std::chrono::steady_clock;
    const std::int64_t batch = watch == Watch::rows ? 8 : 256;
    constexpr std::chrono::milliseconds enough(500);
    using Scalar = typename Problem::Stepper::Scalar;
    auto stepper = Problem::stepper();
    auto x = Problem::initial();
    std::int64_t taken = 0;
    const auto start = Clock::now();
    auto now = start;
    while (taken < steps && now - start < enough) {
        const Run run =
            detail::take(stepper, x, static_cast<Scalar>(h), std::min(batch, steps - taken));
        taken += run.steps;
        if (!run.ok()) { steps = taken; }
        now = Clock::now();
    }
    return taken == 0
               ? 0.0
               : std::chrono::duration<double>(now - start).count() / static_cast<double>(taken);
}

}  // namespace hvi::driver
