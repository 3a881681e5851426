// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/interpret/event_program.hpp"

#include <memory>
#include <optional>
#include <utility>

#include "generator/interpret/tape.hpp"
#include "generator/lower/lowered_events.hpp"
#include "generator/module/driven.hpp"

namespace hvi::gen {

namespace {

using State = DrivenStepper::State;

/// Slots of variables and parameters, and their row.
class EventRow {
public:
    EventRow(const System& system, const LoweredEvents& events,
             const std::vector<double>& parameters)
        : slots_(events.graph) {
        for (const std::vector<Node>& nodes : {coordinate_nodes(system), conjugate_nodes(system)})
            for (const Node node : nodes) variables_.push_back(slots_.of(node));
        if (events.time) time_ = slots_.of(*events.time);
        for (const SystemParameter& parameter : system.parameters)
            parameters_.push_back(slots_.of(parameter.node));
        values_ = parameters;
    }

    [[nodiscard]] Tape tape(std::vector<Scaled> results) {
        return Tape(kernel_of_inputs(slots_.graph(), std::move(results)), slots_);
    }

    /// Ends the making of tapes.
    void close() {
        numbers_ = slots_.numbers();
        for (std::size_t k = 0; k < parameters_.size(); ++k) numbers_[parameters_[k]] = values_[k];
    }

    /// Runs a tape: its results are in their slots.
    void run(const Tape& tape, const State& x, double t) {
        auto slot = variables_.begin();
        for (const double q : x.q) numbers_[*slot++] = q;
        for (const double p : x.p) numbers_[*slot++] = p;
        if (time_) numbers_[*time_] = t;
        tape.run(numbers_.data());
    }

    [[nodiscard]] double result(const Tape& tape, std::size_t k = 0) const {
        return numbers_[tape.results()[k]];
    }

    /// A value that parameters decide.
    [[nodiscard]] double constant(const Tape& tape) {
        tape.run(numbers_.data());
        return result(tape);
    }

private:
    Slots slots_;
    std::vector<Slot> variables_, parameters_;
    std::optional<Slot> time_;
    std::vector<double> values_;
    std::vector<double> numbers_;
};

/// An event as tapes of a row.
struct EventTapes {
    Tape zero;
    std::optional<Tape> slope;
    std::optional<Tape> set;
    Tape cooldown, period;
};

EventTapes tapes_of(const LoweredEvent& event, EventRow& row) {
    EventTapes tapes{
        row.tape({event.zero}), {}, {}, row.tape({event.cooldown}), row.tape({event.period})};
    if (event.slope) tapes.slope = row.tape({*event.slope});
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

double time_span(const std::optional<NamedExpression>& written, const Tape& tape, EventRow& row) {
    const double value = row.constant(tape);
    if (written && !(value >= 0))
        throw InputError("this is negative, or no number", written->place);
    return value;
}

/// NOTE: functions keep the row alive, which is one for all events of a run.
DrivenEvent driven(const LoweredEvent& event, const SceneEvent& scene, EventTapes made,
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
    result.event.is_kink = scene.is_kink;
    result.event.zero = function(tapes->zero);
    result.event.direction = direction_of(event.direction);
    if (tapes->slope) result.event.slope = function(*tapes->slope);
    result.event.cooldown = time_span(scene.cooldown, tapes->cooldown, *row);
    result.event.period = time_span(scene.period, tapes->period, *row);
    if (tapes->set)
        result.set = [row, tapes, set = event.set](State& x, double t) {
            row->run(*tapes->set, x, t);
            jump(x, set, *tapes->set, *row);
        };
    return result;
}

}  // namespace

std::vector<DrivenEvent> driven_events(const System& system, const WrittenOutScene& scene) {
    std::vector<DrivenEvent> result;
    if (scene.events.empty()) return result;
    const DrivenSystem of_modules = driven_system(system);
    const auto events =
        std::make_shared<const LoweredEvents>(lowered_events(of_modules.system, scene));
    const auto row = std::make_shared<EventRow>(of_modules.system, *events, of_modules.numbers);
    std::vector<EventTapes> tapes;
    for (const LoweredEvent& event : events->events) tapes.push_back(tapes_of(event, *row));
    row->close();
    for (std::size_t k = 0; k < tapes.size(); ++k)
        result.push_back(driven(events->events[k], scene.events[k], std::move(tapes[k]), row));
    return result;
}

}  // namespace hvi::gen
