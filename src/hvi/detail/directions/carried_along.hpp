// Directions that a stepper itself carries along.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <hvi/detail/directions/carried_apart.hpp>
#include <hvi/state.hpp>

namespace hvi::detail {

/// Carries any number of directions by the steps of a stepper that takes a pointer to what it
/// carries along: `Stepper::Along`.
template <class Stepper>
class CarriedAlong {
public:
    using State = typename Stepper::State;
    using Scalar = typename Stepper::Scalar;

    explicit CarriedAlong(const Stepper& stepper) : stepper_(stepper) {}

    /// Advances x by the stepper, and the directions along with it. Unless the status is ok, all
    /// have kept their bits. Allocates where there are more directions than ever before.
    template <class Directions>
    [[nodiscard]] Status advance(Stepper& stepper, State& x, Directions& directions, Scalar h) {
        along_.take(directions);
        const Status status = stepper.step(x, h, &along_);
        if (status.ok()) { along_.give(directions); }
        return status;
    }

    /// Carries the directions along the step of size h from x.
    [[nodiscard]] Status step(State x, std::vector<State>& directions, Scalar h) {
        go_on_from(stepper_, x);
        return advance(stepper_, x, directions, h);
    }

    void reset() {
        stepper_.reset();
        along_.forget();
    }

private:
    Stepper stepper_;  ///< of step() alone
    typename Stepper::Along along_;
};

}  // namespace hvi::detail
