// A stepper as a driver of hvi-gen takes it: compiled, or interpreted.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include <hvi/detail/module/departure.hpp>
#include <hvi/detail/module/driven_functions.hpp>

namespace hvi::gen {

/// Steps that carry directions along; see hvi::detail::DrivenFunctions.
class DirectionCarrier {
public:
    DirectionCarrier() = default;
    virtual ~DirectionCarrier() = default;
    DirectionCarrier(const DirectionCarrier&) = delete;
    DirectionCarrier& operator=(const DirectionCarrier&) = delete;

    [[nodiscard]] virtual int carry(double* state, double* directions, std::size_t count,
                                    double h) = 0;
};

/// A stepper whose states are numbers in a row: coordinates, momenta, and the time where H depends
/// on it. See hvi::detail::DrivenFunctions, whose functions these are.
class NumberStepper {
public:
    NumberStepper() = default;
    virtual ~NumberStepper() = default;
    NumberStepper(const NumberStepper&) = delete;
    NumberStepper& operator=(const NumberStepper&) = delete;

    [[nodiscard]] virtual detail::DrivenSizes sizes() const = 0;
    [[nodiscard]] virtual detail::DrivenCounts counts() const = 0;
    virtual void begin(double* state) const = 0;
    [[nodiscard]] virtual int take(double* state, double h, std::int64_t steps) = 0;
    [[nodiscard]] virtual int follow(double* state, double h, std::int64_t steps,
                                     detail::Departure* departures) = 0;
    /// The stepper itself, where its steps carry directions along; else nullptr.
    [[nodiscard]] virtual DirectionCarrier* carrier() { return nullptr; }
    virtual void reset() = 0;
    [[nodiscard]] virtual double energy(const double* state) const = 0;
    virtual void invariants(const double* state, double* values) const = 0;
};

using MakeStepper = std::function<std::unique_ptr<NumberStepper>()>;

/// Returns the steppers for the numbers that those of a scene are made of: parameters and starting
/// values.
using StepperFamily = std::function<MakeStepper(std::vector<double> numbers)>;

}  // namespace hvi::gen
