// Events of a run that hvi-gen drives, and the ends of such a run.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <hvi/detail/trajectories/event.hpp>

#include "generator/drive/driven_stepper.hpp"
#include "generator/drive/event_crossing.hpp"

namespace hvi::gen {

/// An event of a run.
struct DrivenEvent {
    Event<DrivenStepper> event;  ///< has no action of its own
    std::int64_t stop = 0;       ///< the number of the event that ends the run; 0 for none
    std::function<void(DrivenStepper::State&, double)> set = {};  ///< makes it jump; or nothing
    std::string name = {};
    FindCrossing crossing = {};  ///< its derivatives; nothing where they are not built
};

/// The clock of steps in another variable. Time is the last of the coordinates.
struct ScaledClock {
    double until = 0;
};

/// Returns the event that ends the time of a clock.
[[nodiscard]] Event<DrivenStepper> end_of_clock(const ScaledClock& clock);

/// Returns the state without the time of a clock and its momentum.
[[nodiscard]] DrivenStepper::State without_clock(DrivenStepper::State x);

/// Takes the state and the time of an event, and its number among those of its kind, from 1 on.
using OnEvent = std::function<void(std::size_t event, std::int64_t number,
                                   const DrivenStepper::State&, double)>;

/// Returns events that count themselves, are handed to `on_event` where there is one, and end the
/// run or make it jump as they are wished to; with the end of the clock behind them, where there is
/// one. Precondition: the events and the counts, one for each, live longer.
[[nodiscard]] std::vector<Event<DrivenStepper>>
counted_events(const std::vector<DrivenEvent>& events, const std::optional<ScaledClock>& clock,
               std::vector<std::int64_t>& counts, const OnEvent& on_event = nullptr);

/// Reports why a run ended. `end_of_clock` is the number of the event that ends the time.
void tell_ending(const EventRun<double>& run, std::size_t end_of_clock);

}  // namespace hvi::gen
