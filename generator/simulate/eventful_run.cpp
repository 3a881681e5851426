// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/simulate/eventful_run.hpp"

#include <cstddef>

namespace hvi::gen {

EventfulMeasurement measure(const Target& target, const EventfulRunWishes& wishes) {
    const Answers answers = ask(target, wishes);
    EventfulMeasurement result{
        measurement(answers), answers.number("t"), {}, answers.numbers("output")};
    for (const double count : answers.numbers("events", wishes.events.size()))
        result.events.push_back(static_cast<std::int64_t>(count));
    const std::string fault = fault_of_event(answers, wishes.events);
    if (!fault.empty()) result.run.status = fault;
    return result;
}

DepartureSamples sample_departures(const Target& target, const EventfulRunWishes& wishes) {
    return departure_samples(ask(target, wishes));
}

}  // namespace hvi::gen
