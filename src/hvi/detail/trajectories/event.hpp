// Events: functions of the state and the time that pass through zero.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include <hvi/integrate.hpp>
#include <hvi/state.hpp>

namespace hvi {

/// How a function passes through zero where that is an event. NOTE: up is from below to above as
/// the run goes, also where its steps are negative.
enum class Direction { both, up, down };

/// Consequences of an event for the run.
enum class After {
    go_on,  ///< nothing to the run
    stop,   ///< ended the run
    jump,   ///< changed the state, from which the run goes on
};

/// An event: a function of the state and the time that passes through zero.
template <class Stepper>
struct Event {
    using State = typename Stepper::State;
    using Scalar = typename Stepper::Scalar;

    std::function<Scalar(const State&, Scalar)> zero;
    Direction direction = Direction::both;
    /// Called at each event, with its state and time; without it the run just goes on.
    std::function<After(State&, Scalar)> act = {};
    /// The derivative of `zero` along the motion, or nothing. With it two zeros within one step are
    /// found where the function turns once between them.
    std::function<Scalar(const State&, Scalar)> slope = {};
    Scalar cooldown = 0;  ///< the time after an event in which no other one of it counts
    Scalar period = 0;    ///< of an angle, which is zero at its multiples; 0 of what is none
    /// Whether H is not smooth at `zero`. Then a step ends just before it, and the next one begins
    /// just behind it; nothing is called, and it always counts.
    bool is_kink = false;
};

/// Events of the same run.
template <class Stepper, class... More>
[[nodiscard]] std::vector<Event<Stepper>> events(Event<Stepper> first, More... more) {
    return {std::move(first), std::move(more)...};
}

/// Reasons for the end of a run with events.
enum class Ending {
    all_steps,     ///< all were taken
    failed_step,   ///< one of them failed: see the status
    event,         ///< one of them has ended it
    accumulation,  ///< one comes again at once after a jump, or a thousand are in a step
    undefined,     ///< the function of one of them is not a number
    time_stands,   ///< the time of the states does not go on with the steps
};

/// What became of a run with events.
template <class Scalar>
struct [[nodiscard]] EventRun {
    Run run;
    Ending ending = Ending::all_steps;
    std::size_t event = 0;  ///< that has ended it, or is the cause
    Scalar t = 0;           ///< of the state at the end
    Scalar rest = 0;        ///< the size of the short step to the event that has ended it

    [[nodiscard]] bool ok() const { return ending == Ending::all_steps || ending == Ending::event; }
};

}  // namespace hvi
