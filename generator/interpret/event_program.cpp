// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/interpret/event_program.hpp"

#include <memory>
#include <optional>
#include <utility>

#include "generator/interpret/tape.hpp"
#include "generator/lower/loop_events.hpp"
#include "generator/lower/lowered_events.hpp"
#include "generator/module/driven.hpp"

namespace hvi::gen {

namespace {

using State = DrivenStepper::State;

/// Slots of variables and parameters, and their row.
class EventRow {
public:
    explicit EventRow(const LoweredEvents& events) : slots_(events.graph) {
        for (const EventVariable& variable : events.variables)
            variables_.push_back({variable.number, slots_.of(variable.node)});
        if (events.time) time_ = slots_.of(*events.time);
    }

    /// Sets the values of parameters.
    void set(const std::vector<SystemParameter>& parameters, const std::vector<double>& values) {
        for (std::size_t k = 0; k < parameters.size(); ++k)
            parameters_.push_back({slots_.of(parameters[k].node), values[k]});
    }

    [[nodiscard]] Tape tape(std::vector<Scaled> results) {
        return Tape(kernel_of_inputs(slots_.graph(), std::move(results)), slots_);
    }

    /// Ends the making of tapes.
    void close() {
        numbers_ = slots_.numbers();
        for (const auto& [slot, value] : parameters_) numbers_[slot] = value;
    }

    /// Runs a tape: its results are in their slots.
    void run(const Tape& tape, const State& x, double t) {
        const std::size_t n = x.q.size();
        for (const auto& [number, slot] : variables_)
            numbers_[slot] = number < n ? x.q[number] : x.p[number - n];
        if (time_) numbers_[*time_] = t;
        tape.run(numbers_.data());
    }

    [[nodiscard]] double result(const Tape& tape, std::size_t k = 0) const {
        return numbers_[tape.results()[k]];
    }

    /// Returns a value that depends on parameters alone.
    [[nodiscard]] double constant(const Tape& tape) {
        tape.run(numbers_.data());
        return result(tape);
    }

private:
    Slots slots_;
    std::vector<std::pair<std::size_t, Slot>> variables_;
    std::vector<std::pair<Slot, double>> parameters_;
    std::optional<Slot> time_;
    std::vector<double> numbers_;
};

/// An event as tapes of a row.
struct EventTapes {
    Tape zero;
    std::optional<Tape> slope, crossing, set, cooldown, period;
};

/// Returns a tape of derivatives at an event: by the time, by the variables, and along the motion.
Tape tape_of_crossing(const LoweredEvent& event, const std::vector<Scaled>& motion, EventRow& row) {
    std::vector<Scaled> values{event.by_time};
    values.insert(values.end(), event.by_variables.begin(), event.by_variables.end());
    values.insert(values.end(), motion.begin(), motion.end());
    return row.tape(std::move(values));
}

EventTapes tapes_of(const LoweredEvents& events, const LoweredEvent& event, EventRow& row) {
    EventTapes tapes{row.tape({event.zero}), {}, {}, {}, {}, {}};
    if (event.slope) tapes.slope = row.tape({*event.slope});
    if (!events.motion.empty()) tapes.crossing = tape_of_crossing(event, events.motion, row);
    if (event.cooldown) tapes.cooldown = row.tape({event.cooldown->value});
    if (event.period) tapes.period = row.tape({event.period->value});
    if (event.set.empty()) return tapes;
    std::vector<Scaled> values;
    for (const LoweredJump& jump : event.set) values.push_back(jump.value);
    tapes.set = row.tape(std::move(values));
    return tapes;
}

Direction direction_of(EventDirection direction) {
    switch (direction) {
    case EventDirection::both: break;
    case EventDirection::up: return Direction::up;
    case EventDirection::down: return Direction::down;
    }
    return Direction::both;
}

void jump(State& x, const std::vector<LoweredJump>& set, const Tape& tape, const EventRow& row) {
    const std::size_t n = x.q.size();
    for (std::size_t k = 0; k < set.size(); ++k) {
        const std::size_t variable = set[k].variable;
        (variable < n ? x.q[variable] : x.p[variable - n]) = row.result(tape, k);
    }
}

/// NOTE: there are as many variables as derivatives along the motion.
EventCrossing crossing_at(const Tape& tape, const EventRow& row) {
    EventCrossing result;
    result.by_time = row.result(tape);
    const std::size_t count = (tape.results().size() - 1) / 2;
    for (std::size_t k = 0; k < count; ++k) {
        result.by_state.push_back(row.result(tape, 1 + k));
        result.motion.push_back(row.result(tape, 1 + count + k));
    }
    return result;
}

/// Returns the value of a time span; 0 where none is given.
double time_span(const std::optional<LoweredSpan>& written, const std::optional<Tape>& tape,
                 EventRow& row) {
    if (!written) return 0;
    const double value = row.constant(*tape);
    if (!(value >= 0)) throw InputError("this is negative, or no number", written->place);
    return value;
}

/// NOTE: the functions keep the row alive, which all events of a run share.
DrivenEvent driven(const LoweredEvent& event, EventTapes made,
                   const std::shared_ptr<EventRow>& row) {
    const auto tapes = std::make_shared<const EventTapes>(std::move(made));
    const auto function = [row, tapes](const Tape& tape) {
        return [row, tapes, &tape](const State& x, double t) {
            row->run(tape, x, t);
            return row->result(tape);
        };
    };
    DrivenEvent result;
    result.name = event.name;
    result.stop = event.stop;
    result.event.is_kink = event.is_kink;
    result.event.zero = function(tapes->zero);
    result.event.direction = direction_of(event.direction);
    if (tapes->slope) result.event.slope = function(*tapes->slope);
    if (tapes->crossing)
        result.crossing = [row, tapes](const State& x, double t) {
            row->run(*tapes->crossing, x, t);
            return crossing_at(*tapes->crossing, *row);
        };
    result.event.cooldown = time_span(event.cooldown, tapes->cooldown, *row);
    result.event.period = time_span(event.period, tapes->period, *row);
    if (tapes->set)
        result.set = [row, tapes, set = event.set](State& x, double t) {
            row->run(*tapes->set, x, t);
            jump(x, set, *tapes->set, *row);
        };
    return result;
}

/// Returns the events of a row whose parameters are set.
std::vector<DrivenEvent> driven(const LoweredEvents& events, const std::shared_ptr<EventRow>& row) {
    std::vector<EventTapes> tapes;
    for (const LoweredEvent& event : events.events) tapes.push_back(tapes_of(events, event, *row));
    row->close();
    std::vector<DrivenEvent> result;
    for (std::size_t k = 0; k < tapes.size(); ++k)
        result.push_back(driven(events.events[k], std::move(tapes[k]), row));
    return result;
}

}  // namespace

std::vector<DrivenEvent> driven_events(const System& system, const WrittenOutScene& scene) {
    if (scene.events.empty()) return {};
    const DrivenSystem of_modules = driven_system(system);
    const LoweredEvents events = lowered_events(of_modules.system, scene);
    const auto row = std::make_shared<EventRow>(events);
    row->set(of_modules.system.parameters, of_modules.numbers);
    return driven(events, row);
}

FindMotion driven_motion(const System& system, const WrittenOutScene& scene) {
    const DrivenSystem of_modules = driven_system(system);
    const LoweredEvents lowered = lowered_events(of_modules.system, scene);
    const auto row = std::make_shared<EventRow>(lowered);
    row->set(of_modules.system.parameters, of_modules.numbers);
    const auto tape = std::make_shared<const Tape>(row->tape(lowered.motion));
    row->close();
    return [row, tape](const State& x) {
        row->run(*tape, x, 0);
        std::vector<double> result;
        for (std::size_t k = 0; k < tape->results().size(); ++k)
            result.push_back(row->result(*tape, k));
        return result;
    };
}

std::vector<DrivenEvent> driven_events(const Scene& scene) {
    if (scene.events.empty()) return {};
    const LoweredEvents events = lowered_events(scene);
    return driven(events, std::make_shared<EventRow>(events));
}

}  // namespace hvi::gen
