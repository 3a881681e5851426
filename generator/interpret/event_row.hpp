// Code of events on one row of numbers.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <hvi/detail/linear/dense.hpp>

#include "generator/drive/driven_stepper.hpp"
#include "generator/interpret/tape.hpp"
#include "generator/lower/lowered_events.hpp"

namespace hvi::gen {

/// A tape, and what it takes of a state.
struct EventCode {
    Tape tape;
    std::vector<std::pair<std::size_t, Slot>> variables;  ///< by their numbers
    std::optional<Slot> time = {};
    bool takes_velocities = false;  ///< which are solved for
};

/// Numbers that all events of a run share: variables, parameters, and what is computed of them.
class EventRow {
public:
    using State = DrivenStepper::State;

    /// Precondition: the events live longer than code is made.
    explicit EventRow(const LoweredEvents& events);

    /// Sets the values of parameters.
    void set(const std::vector<SystemParameter>& parameters, const std::vector<double>& values);

    [[nodiscard]] EventCode code(std::vector<Scaled> results);

    /// Ends the making of code.
    void close();

    /// Runs code: its results are in their slots.
    void run(const EventCode& code, const State& x, double t);

    /// Sets the weights of velocities to the solution of M w = g, where g is what the code computes
    /// at the state.
    void weigh(const EventCode& by_velocities, const State& x, double t);

    [[nodiscard]] double result(const EventCode& code, std::size_t k = 0) const {
        return numbers_[code.tape.results()[k]];
    }

    /// Returns a value that depends on parameters alone.
    [[nodiscard]] double constant(const EventCode& code);

private:
    /// Equations that the velocities of a state solve, and the last solution.
    struct Solving {
        EventCode equations;  ///< dL/dv at rest, and M
        std::vector<Slot> velocities, weights;
        detail::SquareMatrix<double> mass;
        detail::Factors<double> factors = {};
        bool is_regular = false;
        State at = {};
        double t = 0;
        std::vector<double> found = {}, weighed = {};
    };

    void put(const EventCode& code, const State& x, double t);
    /// Sets the velocities of a state; they are no numbers where M is singular.
    void solve(const State& x, double t);
    void factorise(const State& x, double t);

    Slots slots_;
    std::map<Node, std::size_t> variables_;
    std::optional<Node> time_;
    std::vector<Node> solved_;  ///< velocities and their weights
    std::vector<std::pair<Slot, double>> parameters_;
    std::optional<Solving> solving_;
    std::vector<double> numbers_;
};

}  // namespace hvi::gen
