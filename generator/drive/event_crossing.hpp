// Derivatives at the crossing of an event.
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
    std::vector<double> by_state;  ///< derivative of `zero` by coordinates, then by momenta
    double by_time = 0;            ///< derivative of `zero` by time
    std::vector<double> motion;    ///< derivatives of coordinates and momenta along the motion

    /// Returns the derivative of `zero` along the motion.
    [[nodiscard]] double speed() const { return product_of(by_state, motion) + by_time; }
};

using FindCrossing = std::function<EventCrossing(const DrivenStepper::State&, double)>;

/// Derivatives of an event by the start.
struct EventDerivative {
    DirectionVector time;                ///< derivatives of its time
    std::vector<DirectionVector> state;  ///< a column for each of these numbers
};

/// Returns the derivatives of an event by the start. Here g is its `zero`, f the motion, and D the
/// derivative of the state at the time of the event, with the given columns:
///
///     dt = -(grad g D)/(grad g f + dg/dt), and the state moves by D + f dt.
///
/// Returns nothing where the motion touches the surface without crossing it: dt is no number there.
[[nodiscard]] std::optional<EventDerivative>
event_derivative(const EventCrossing& crossing, const std::vector<DirectionVector>& columns);

}  // namespace hvi::gen
