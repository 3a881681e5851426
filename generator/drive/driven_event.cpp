// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/drive/driven_event.hpp"

#include <driver/answer.hpp>

namespace hvi::gen {

Event<DrivenStepper> end_of_clock(const ScaledClock& clock) {
    Event<DrivenStepper> event;
    event.zero = [until = clock.until](const DrivenStepper::State& x, double) {
        return x.q.back() - until;
    };
    event.act = [](DrivenStepper::State&, double) { return After::stop; };
    return event;
}

DrivenStepper::State without_clock(DrivenStepper::State x) {
    x.q.pop_back();
    x.p.pop_back();
    return x;
}

std::vector<Event<DrivenStepper>> counted_events(const std::vector<DrivenEvent>& events,
                                                 const std::optional<ScaledClock>& clock,
                                                 std::vector<std::int64_t>& counts,
                                                 const OnEvent& on_event) {
    std::vector<Event<DrivenStepper>> result;
    for (const DrivenEvent& each : events) {
        const std::size_t i = result.size();
        result.push_back(each.event);
        result.back().act = [&counts, &each, i, on_event](DrivenStepper::State& x, double t) {
            ++counts[i];
            if (on_event) on_event(i, counts[i], x, t);
            if (counts[i] == each.stop) return After::stop;
            if (!each.set) return After::go_on;
            each.set(x, t);
            return After::jump;
        };
    }
    if (clock) result.push_back(end_of_clock(*clock));
    return result;
}

void tell_ending(const EventRun<double>& run, std::size_t end_of_clock) {
    const auto event = static_cast<std::int64_t>(run.event);
    driver::say("status", run.ending == Ending::failed_step ? run.run.status.message() : "ok");
    if (run.ending == Ending::event && run.event != end_of_clock) driver::say("stopped_by", event);
    if (run.ending == Ending::time_stands)
        driver::say("status", "the time does not go on with the steps");
    if (run.ending == Ending::accumulation) driver::say("accumulates", event);
    if (run.ending == Ending::undefined) driver::say("undefined", event);
}

}  // namespace hvi::gen
