// What a run should keep, and how well it does.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace hvi::driver {

/// How far a quantity has departed from what it was at the start.
struct Departure {
    double start = 0, largest = 0, last = 0;

    void see(double value) {
        last = value - start;
        // NOTE: so that what is no number counts as large.
        if (!(std::abs(last) <= largest)) { largest = std::abs(last); }
    }
};

/// The invariants of `Problem` over a run.
template <class Problem>
class Invariants {
public:
    static constexpr std::size_t count = Problem::invariants.size();

    /// Precondition: `x` is where the run begins.
    template <class Stepper, class State>
    Invariants(const Stepper& stepper, const State& x) : values_(Problem::values(stepper, x)) {
        for (std::size_t i = 0; i < count; ++i) { departures_[i].start = values_[i]; }
    }

    template <class Stepper, class State>
    void see(const Stepper& stepper, const State& x) {
        values_ = Problem::values(stepper, x);
        for (std::size_t i = 0; i < count; ++i) { departures_[i].see(values_[i]); }
    }

    [[nodiscard]] const std::array<double, count>& values() const { return values_; }
    [[nodiscard]] const std::array<Departure, count>& departures() const { return departures_; }

private:
    std::array<double, count> values_;
    std::array<Departure, count> departures_{};
};

}  // namespace hvi::driver
