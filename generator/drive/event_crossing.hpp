// Derivatives where a run meets an event.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "generator/drive/directions.hpp"
#include "generator/drive/driven_stepper.hpp"

namespace hvi::gen {

/// Derivatives at the state of an event.
struct EventCrossing {
    std::vector<double> by_state;  ///< of `zero`, by coordinates, then by momenta
    double by_time = 0;            ///< of `zero`
    std::vector<double> motion;    ///< of coordinates and momenta, along the motion

    /// The derivative of `zero` along the motion.
    [[nodiscard]] double speed() const { return product_of(by_state, motion) + by_time; }
};

using FindCrossing = std::function<EventCrossing(const DrivenStepper::State&, double)>;

/// How the event moves with the start.
struct EventDerivative {
    DirectionVector time;                ///< of its time, by each number of the start
    std::vector<DirectionVector> state;  ///< of its state, a column for each of these
};

/// Moves the event with the start, where g is its `zero`, f the motion, and D the derivative of the
/// state at the time of the event, whose columns these are:
///
///     dt = -(grad g D)/(grad g f + dg/dt), and the state moves by D + f dt.
///
/// Nothing where the motion does not cross the surface, but touches it: dt is no number there.
[[nodiscard]] std::optional<EventDerivative>
event_derivative(const EventCrossing& crossing, const std::vector<DirectionVector>& columns);

}  // namespace hvi::gen
