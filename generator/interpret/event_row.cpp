// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/interpret/event_row.hpp"

#include <algorithm>
#include <limits>

#include "generator/lower/kernel.hpp"

namespace hvi::gen {

namespace {

std::vector<Slot> slots_of(const std::vector<Node>& nodes, Slots& slots) {
    std::vector<Slot> result;
    for (const Node node : nodes) result.push_back(slots.of(node));
    return result;
}

}  // namespace

EventRow::EventRow(const LoweredEvents& events) : slots_(events.graph), time_(events.time) {
    for (const EventVariable& variable : events.variables)
        variables_[variable.node] = variable.number;
    if (!events.velocities) return;
    const LoweredVelocities& lowered = *events.velocities;
    solved_ = lowered.velocities;
    solved_.insert(solved_.end(), lowered.weights.begin(), lowered.weights.end());
    std::vector<Scaled> equations = lowered.momenta;
    equations.insert(equations.end(), lowered.mass.begin(), lowered.mass.end());
    Solving& solving = solving_.emplace(
        Solving{code(equations), slots_of(lowered.velocities, slots_),
                slots_of(lowered.weights, slots_), detail::SquareMatrix<double>(events.degrees)});
    solving.found.resize(events.degrees);
    solving.weighed.resize(lowered.weights.size());
}

void EventRow::set(const std::vector<SystemParameter>& parameters,
                   const std::vector<double>& values) {
    for (std::size_t k = 0; k < parameters.size(); ++k)
        parameters_.push_back({slots_.of(parameters[k].node), values[k]});
}

EventCode EventRow::code(std::vector<Scaled> results) {
    const Kernel kernel = kernel_of_inputs(slots_.graph(), std::move(results));
    EventCode result{Tape(kernel, slots_), {}};
    for (const Node node : kernel.given) {
        if (const auto found = variables_.find(node); found != variables_.end())
            result.variables.push_back({found->second, slots_.of(node)});
        if (node == time_) result.time = slots_.of(node);
        if (std::find(solved_.begin(), solved_.end(), node) != solved_.end())
            result.takes_velocities = true;
    }
    return result;
}

void EventRow::close() {
    numbers_ = slots_.numbers();
    for (const auto& [slot, value] : parameters_) numbers_[slot] = value;
}

void EventRow::put(const EventCode& code, const State& x, double t) {
    const std::size_t n = x.q.size();
    for (const auto& [number, slot] : code.variables)
        numbers_[slot] = number < n ? x.q[number] : x.p[number - n];
    if (code.time) numbers_[*code.time] = t;
}

void EventRow::run(const EventCode& code, const State& x, double t) {
    if (code.takes_velocities) solve(x, t);
    put(code, x, t);
    code.tape.run(numbers_.data());
}

/// NOTE: of all events of a step, the first one solves.
void EventRow::solve(const State& x, double t) {
    Solving& solving = *solving_;
    if (x.q != solving.at.q || x.p != solving.at.p || t != solving.t) factorise(x, t);
    for (std::size_t k = 0; k < solving.found.size(); ++k)
        numbers_[solving.velocities[k]] = solving.found[k];
}

void EventRow::factorise(const State& x, double t) {
    Solving& solving = *solving_;
    const std::size_t n = solving.found.size();
    for (const Slot slot : solving.velocities) numbers_[slot] = 0;
    put(solving.equations, x, t);
    solving.equations.tape.run(numbers_.data());
    for (std::size_t i = 0; i < n; ++i) {
        solving.found[i] = x.p[i] - result(solving.equations, i);
        for (std::size_t j = 0; j < n; ++j)
            solving.mass(i, j) = result(solving.equations, n + i * n + j);
    }
    solving.is_regular = solving.factors.compute(solving.mass);
    if (solving.is_regular)
        solving.factors.solve(solving.found.data());
    else
        std::fill(solving.found.begin(), solving.found.end(),
                  std::numeric_limits<double>::quiet_NaN());
    solving.at = x;
    solving.t = t;
}

void EventRow::weigh(const EventCode& by_velocities, const State& x, double t) {
    solve(x, t);
    run(by_velocities, x, t);
    Solving& solving = *solving_;
    std::vector<double>& weights = solving.weighed;
    for (std::size_t k = 0; k < weights.size(); ++k) weights[k] = result(by_velocities, k);
    if (solving.is_regular) solving.factors.solve(weights.data());
    for (std::size_t k = 0; k < weights.size(); ++k) numbers_[solving.weights[k]] = weights[k];
}

double EventRow::constant(const EventCode& code) {
    code.tape.run(numbers_.data());
    return result(code);
}

}  // namespace hvi::gen
