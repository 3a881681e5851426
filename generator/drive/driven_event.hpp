// Events of a run that hvi-gen drives, and how such a run ends.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

#include <hvi/detail/trajectories/event.hpp>

#include "generator/drive/driven_stepper.hpp"
#include "generator/drive/event_crossing.hpp"

namespace hvi::gen {

/// An event of a run.
struct DrivenEvent {
    Event<DrivenStepper> event;  ///< which does nothing of its own
    std::int64_t stop = 0;       ///< the run ends at this one; 0 for none
    std::function<void(DrivenStepper::State&, double)> set = {};  ///< what jumps; or nothing
    std::string name = {};
    FindCrossing crossing = {};  ///< its derivatives; nothing where they are not built
};

/// The time where steps are of another variable: the last of the coordinates.
struct ScaledClock {
    double until = 0;
};

/// The event that ends the time of a clock.
[[nodiscard]] Event<DrivenStepper> end_of_clock(const ScaledClock& clock);

/// The state without the time of a clock and its momentum.
[[nodiscard]] DrivenStepper::State without_clock(DrivenStepper::State x);

/// Says why a run ended. `end_of_clock` is the number of the event that ends the time.
void tell_ending(const EventRun<double>& run, std::size_t end_of_clock);

}  // namespace hvi::gen
