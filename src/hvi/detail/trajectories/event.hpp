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

/// Direction in which a function passes through zero at an event. NOTE: up is from below to above
/// in the order of the run, also where its steps are negative.
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
    /// The derivative of `zero` along the motion, or empty. With it two zeros within one step are
    /// found where the function turns once between them.
    std::function<Scalar(const State&, Scalar)> slope = {};
    Scalar cooldown = 0;  ///< time after an event in which this event does not count again
    Scalar period = 0;    ///< of an angle, which is zero at its multiples; 0: no angle
    /// Whether H is not smooth at `zero`. A step then ends just before the zero, and the next one
    /// begins just behind it; act() is not called, and the zero always counts.
    bool is_kink = false;
};

/// Returns a list of the events of one run.
template <class Stepper, class... More>
[[nodiscard]] std::vector<Event<Stepper>> events(Event<Stepper> first, More... more) {
    return {std::move(first), std::move(more)...};
}

/// Reasons for the end of a run with events.
enum class Ending {
    all_steps,     ///< all were taken
    failed_step,   ///< one of them failed: see the status
    event,         ///< one of them has ended it
    accumulation,  ///< an event comes again at once after a jump, or a thousand are in a step
    undefined,     ///< the function of an event is not a number
    time_stands,   ///< the time of the states does not go on with the steps
};

/// Result of a run with events.
template <class Scalar>
struct [[nodiscard]] EventRun {
    Run run;
    Ending ending = Ending::all_steps;
    std::size_t event = 0;  ///< number of the event that has ended the run, or is the cause
    Scalar t = 0;           ///< of the state at the end
    Scalar rest = 0;        ///< size of the short step to the event that has ended the run

    [[nodiscard]] bool ok() const { return ending == Ending::all_steps || ending == Ending::event; }
};

}  // namespace hvi
