// States within a step of a run, by shorter steps from its start.
// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include <hvi/state.hpp>

namespace hvi::detail {

/// Stretch of a run between two states, which one step connects.
template <class Stepper>
class ShortSteps {
public:
    using State = typename Stepper::State;
    using Scalar = typename Stepper::Scalar;

    /// Takes short steps with a stepper of its own, so that the run keeps its bits.
    explicit ShortSteps(Stepper stepper) : stepper_(std::move(stepper)) {}

    State from, to;
    Scalar t = 0, t_end = 0;  ///< times of `from` and `to`
    Scalar span = 0;          ///< the size of the step

    /// Writes the state at a part of the stretch, from 0 to 1. Unless the status is ok, `x` is of
    /// no use.
    Status at(Scalar part, State& x) {
        x = part == 1 ? to : from;
        return part == 0 || part == 1 ? Status() : short_step(x, part * span);
    }

    Status short_step(State& x, Scalar h) {
        stepper_.reset();
        return stepper_.step(x, h);
    }

    [[nodiscard]] Scalar time_at(Scalar part) const { return part == 1 ? t_end : t + part * span; }

private:
    Stepper stepper_;
};

}  // namespace hvi::detail
