// Runs with events: where functions of the state pass through zero.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include <hvi/detail/trajectories/event.hpp>
#include <hvi/detail/trajectories/event_steps.hpp>
#include <hvi/integrate.hpp>

namespace hvi {

/// Takes steps as integrate() without events does, and looks for events on the way. The state at an
/// event is found by a shorter step from the beginning of the step that contains it, to a few units
/// in the last place of the time. So a method conserves at events what it conserves at steps. The
/// other steps keep their bits, unless an event jumps: then a shorter step leads to the end of the
/// step that contains it.
///
/// Finds an event where the sign of its function differs at both ends of a step. With a slope,
/// events are also found where the function turns once within the step, beyond zero. Other events
/// are missed: two zeros in one step without a slope, or with more than one turn. A zero at the
/// start alone is no event, nor is a zero without a change of sign.
/// # Use
/// h may be negative, as without events, and a step that fails ends the run. Events
/// within one step come in the order of time, and events of one time in the order of the list.
/// observe(x, t) is called where steps begin and end, and at the end of the run.
/// ```cpp
/// #include <array>
/// #include <cmath>
///
/// #include <hvi/events.hpp>
/// #include <hvi/generated/stormer_verlet_separable.hpp>
///
/// struct Ball {  // H = p^2/2 + q, above a floor at q = 0
///     using Vector = std::array<double, 1>;
///     void dHdq(const Vector&, Vector& out) const { out = {1.0}; }
///     void dHdp(const Vector& p, Vector& out) const { out = p; }
/// };
///
/// int main() {
///     using Stepper = hvi::generated::StormerVerletSeparable<Ball>;
///     int bounces = 0;
///     double last = 0;
///     hvi::Event<Stepper> floor;
///     floor.zero = [](const auto& x, double) { return x.q[0]; };
///     floor.direction = hvi::Direction::down;
///     floor.act = [&](auto& x, double t) {
///         x.p[0] = -x.p[0];
///         ++bounces;
///         last = t;
///         return hvi::After::jump;
///     };
///     Stepper stepper;
///     hvi::State<Ball::Vector> x{{0.5}, {0.0}};
///     const auto run = hvi::integrate(stepper, x, 0.0, 0.1, 60, hvi::events(floor));
///     // It falls for a time of 1, then is up in the air for 2, twice.
///     const bool is_last = bounces == 3 && std::abs(last - 5) < 1e-13;
///     return run.ok() && is_last && std::abs(x.q[0] - 0.5) < 1e-13 ? 0 : 1;
/// }
/// ```
template <class Stepper, class Observer>
EventRun<typename Stepper::Scalar>
integrate(Stepper& stepper, typename Stepper::State& x, typename Stepper::Scalar start,
          typename Stepper::Scalar h, std::int64_t steps, std::vector<Event<Stepper>> events,
          Observer&& observe) {
    using Scalar = typename Stepper::Scalar;
    const auto& unchanged = x;
    detail::EventSteps<Stepper> all(std::move(events), stepper);
    EventRun<Scalar> result;
    result.t = start;
    observe(unchanged, start);
    all.begin(x, start, h);
    while (result.run.steps < steps && result.ending == Ending::all_steps) {
        const Scalar next = start + static_cast<Scalar>(result.run.steps + 1) * h;
        all.take(stepper, x, h, next, result);
        if (result.ending != Ending::failed_step) { observe(unchanged, result.t); }
    }
    if (result.ending == Ending::all_steps) { all.finish(x, h, result); }
    return result;
}

/// Takes steps with events, without an observer.
template <class Stepper>
EventRun<typename Stepper::Scalar>
integrate(Stepper& stepper, typename Stepper::State& x, typename Stepper::Scalar start,
          typename Stepper::Scalar h, std::int64_t steps, std::vector<Event<Stepper>> events) {
    return integrate(stepper, x, start, h, steps, std::move(events), [](const auto&, auto) {});
}

}  // namespace hvi
