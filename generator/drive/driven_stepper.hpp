// A stepper of numbers as src/hvi and src/driver take steppers.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <hvi/integrate.hpp>
#include <hvi/state.hpp>

#include "generator/drive/number_stepper.hpp"

namespace hvi::gen {

class DrivenStepper {
public:
    using Scalar = double;
    struct State : hvi::State<std::vector<double>> {
        std::vector<double> time = {};  ///< one number where H depends on it
    };

    explicit DrivenStepper(MakeStepper make);

    /// A copy is a new stepper, which has taken no steps.
    DrivenStepper(const DrivenStepper& other) : DrivenStepper(other.make_) {}
    DrivenStepper(DrivenStepper&&) = default;
    DrivenStepper& operator=(const DrivenStepper&) = delete;
    DrivenStepper& operator=(DrivenStepper&&) = default;
    ~DrivenStepper() = default;

    [[nodiscard]] State initial() const;

    [[nodiscard]] Status step(State& x, double h) { return advance(x, h, 1).status; }
    /// Throws std::bad_alloc, and SolverIsApart.
    [[nodiscard]] Run advance(State& x, double h, std::int64_t steps);
    /// Takes steps as advance() does, and looks after each at what is conserved().
    [[nodiscard]] Run follow(State& x, double h, std::int64_t steps,
                             std::vector<detail::Departure>& departures);
    /// Whether steps carry directions along; else states may be those of with_tangent().
    [[nodiscard]] bool carries_directions() const { return stepper_->carrier() != nullptr; }
    /// Takes a step, and so many directions along: of each its numbers in a row. Throws as
    /// advance() does. Precondition: steps carry them.
    [[nodiscard]] Status carry(State& x, std::vector<double>& directions, std::size_t count,
                               double h);
    /// Forgets what steps have left behind: what follows has the bits of a new stepper.
    void reset() { stepper_->reset(); }
    [[nodiscard]] std::int64_t evaluations() const { return stepper_->counts().evaluations; }

    /// Names of what a run is to keep: the energy, where H does not depend on the time, and the
    /// invariants of the scene, whose names do not matter here.
    [[nodiscard]] std::vector<std::string> conserved() const;
    /// Writes their values.
    void values(const State& x, double* out) const;

private:
    /// Advances the state by take(numbers).
    template <class Take>
    [[nodiscard]] Run advanced(State& x, Take take);
    /// The numbers of a state in a row, until the next call.
    [[nodiscard]] double* in_a_row(const State& x) const;
    void set(State& x, const std::vector<double>& numbers) const;

    MakeStepper make_;
    std::unique_ptr<NumberStepper> stepper_;
    detail::DrivenSizes sizes_;
    mutable std::vector<double> numbers_;
};

}  // namespace hvi::gen
