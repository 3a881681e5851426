// Many steps of any stepper.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <type_traits>
#include <utility>

#include <hvi/detail/run.hpp>

namespace hvi::detail {

/// Whether a stepper has advance(), which takes many steps faster than one after the other.
template <class Stepper, class = void>
struct Advances : std::false_type {};
template <class Stepper>
struct Advances<Stepper, std::void_t<decltype(std::declval<Stepper&>().advance(
                             std::declval<typename Stepper::State&>(), 0.0, std::int64_t(1)))>>
    : std::true_type {};

/// Takes `steps` steps, or as many as go well.
template <class Stepper>
Run take(Stepper& stepper, typename Stepper::State& x, typename Stepper::Scalar h,
         std::int64_t steps) {
    if constexpr (Advances<Stepper>::value) {
        return stepper.advance(x, h, steps);
    } else {
        Run run;
        while (run.steps < steps) {
            run.status = stepper.step(x, h);
            run.iterations += run.status.iterations;
            if (!run.ok()) { break; }
            ++run.steps;
        }
        return run;
    }
}

}  // namespace hvi::detail
