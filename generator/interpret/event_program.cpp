// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/interpret/event_program.hpp"

#include <memory>
#include <optional>
#include <utility>

#include "generator/interpret/event_row.hpp"
#include "generator/lower/loop_events.hpp"
#include "generator/lower/lowered_events.hpp"
#include "generator/module/driven.hpp"

namespace hvi::gen {

namespace {

using State = DrivenStepper::State;

/// An event as code on a row.
struct CodeOfEvent {
    EventCode zero;
    std::optional<EventCode> slope, by_velocities, crossing, set, cooldown, period;
};

/// Returns the values of the motion, by the numbers of variables.
std::vector<Scaled> values_of(const EventMotion& motion) {
    std::vector<Scaled> values;
    for (const auto& [number, value] : motion) values.push_back(value);
    return values;
}

/// Returns code for derivatives at an event: by the time, by the variables, and along the motion.
EventCode code_of_crossing(const LoweredEvents& events, const LoweredEvent& event, EventRow& row) {
    std::vector<Scaled> by_variables(2 * events.degrees, Graph::number(0));
    for (const auto& [number, value] : event.by_variables) by_variables[number] = value;
    std::vector<Scaled> values{event.by_time};
    values.insert(values.end(), by_variables.begin(), by_variables.end());
    const std::vector<Scaled> motion = values_of(events.motion);
    values.insert(values.end(), motion.begin(), motion.end());
    return row.code(std::move(values));
}

CodeOfEvent code_of(const LoweredEvents& events, const LoweredEvent& event, EventRow& row) {
    CodeOfEvent code{row.code({event.zero}), {}, {}, {}, {}, {}, {}};
    if (event.slope) code.slope = row.code({*event.slope});
    if (!event.by_velocities.empty()) code.by_velocities = row.code(event.by_velocities);
    if (event.slope && event.stop != 0 && events.moves_all())
        code.crossing = code_of_crossing(events, event, row);
    if (event.cooldown) code.cooldown = row.code({event.cooldown->value});
    if (event.period) code.period = row.code({event.period->value});
    if (event.set.empty()) return code;
    std::vector<Scaled> values;
    for (const LoweredJump& jump : event.set) values.push_back(jump.value);
    code.set = row.code(std::move(values));
    return code;
}

Direction direction_of(EventDirection direction) {
    switch (direction) {
    case EventDirection::both: break;
    case EventDirection::up: return Direction::up;
    case EventDirection::down: return Direction::down;
    }
    return Direction::both;
}

void jump(State& x, const std::vector<LoweredJump>& set, const EventCode& code,
          const EventRow& row) {
    const std::size_t n = x.q.size();
    for (std::size_t k = 0; k < set.size(); ++k) {
        const std::size_t variable = set[k].variable;
        (variable < n ? x.q[variable] : x.p[variable - n]) = row.result(code, k);
    }
}

/// NOTE: there are as many variables as derivatives along the motion.
EventCrossing crossing_at(const EventCode& code, const EventRow& row) {
    EventCrossing result;
    result.by_time = row.result(code);
    const std::size_t count = (code.tape.results().size() - 1) / 2;
    for (std::size_t k = 0; k < count; ++k) {
        result.by_state.push_back(row.result(code, 1 + k));
        result.motion.push_back(row.result(code, 1 + count + k));
    }
    return result;
}

/// Returns the value of a time span; 0 where none is given.
double time_span(const std::optional<LoweredSpan>& written, const std::optional<EventCode>& code,
                 EventRow& row) {
    if (!written) return 0;
    const double value = row.constant(*code);
    if (!(value >= 0)) throw InputError("this is negative, or no number", written->place);
    return value;
}

/// Runs code that may depend on derivatives by velocities, as slopes do.
void run_slope(const CodeOfEvent& of, const EventCode& code, EventRow& row, const State& x,
               double t) {
    if (of.by_velocities) row.weigh(*of.by_velocities, x, t);
    row.run(code, x, t);
}

/// NOTE: the functions keep the row alive, which all events of a run share.
DrivenEvent driven(const LoweredEvent& event, CodeOfEvent made,
                   const std::shared_ptr<EventRow>& row) {
    const auto code = std::make_shared<const CodeOfEvent>(std::move(made));
    DrivenEvent result;
    result.name = event.name;
    result.stop = event.stop;
    result.event.is_kink = event.is_kink;
    result.event.direction = direction_of(event.direction);
    result.event.zero = [row, code](const State& x, double t) {
        row->run(code->zero, x, t);
        return row->result(code->zero);
    };
    if (code->slope)
        result.event.slope = [row, code](const State& x, double t) {
            run_slope(*code, *code->slope, *row, x, t);
            return row->result(*code->slope);
        };
    if (code->crossing)
        result.crossing = [row, code](const State& x, double t) {
            run_slope(*code, *code->crossing, *row, x, t);
            return crossing_at(*code->crossing, *row);
        };
    result.event.cooldown = time_span(event.cooldown, code->cooldown, *row);
    result.event.period = time_span(event.period, code->period, *row);
    if (code->set)
        result.set = [row, code, set = event.set](State& x, double t) {
            row->run(*code->set, x, t);
            jump(x, set, *code->set, *row);
        };
    return result;
}

/// Returns the events of a row whose parameters are set.
std::vector<DrivenEvent> driven(const LoweredEvents& events, const std::shared_ptr<EventRow>& row) {
    std::vector<CodeOfEvent> code;
    for (const LoweredEvent& event : events.events) code.push_back(code_of(events, event, *row));
    row->close();
    std::vector<DrivenEvent> result;
    for (std::size_t k = 0; k < code.size(); ++k)
        result.push_back(driven(events.events[k], std::move(code[k]), row));
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
    const auto code = std::make_shared<const EventCode>(row->code(values_of(lowered.motion)));
    row->close();
    return [row, code](const State& x) {
        row->run(*code, x, 0);
        std::vector<double> result;
        for (std::size_t k = 0; k < code->tape.results().size(); ++k)
            result.push_back(row->result(*code, k));
        return result;
    };
}

std::vector<DrivenEvent> driven_events(const Scene& scene) {
    if (scene.events.empty()) return {};
    const LoweredEvents events = lowered_events(scene);
    return driven(events, std::make_shared<EventRow>(events));
}

}  // namespace hvi::gen
