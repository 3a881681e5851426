// Steps of the rows of an ensemble on a device: each row has its own size of steps, and their
// number.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include <hvi/detail/device/device.hpp>
#include <hvi/state.hpp>

namespace hvi::device {

/// The departure of a quantity from its start; see detail::Departure.
struct LargestDeparture {
    double start = 0, largest = 0;

    HVI_DEVICE void see(double value) {
        const double last = value + 0.0 - start;
        const double size = last < 0 ? -last : last;
        if (!(size <= largest)) { largest = size; }
    }
};

/// A row before it begins.
template <class Stepper>
struct RowStart {
    typename Stepper::Parameters parameters;
    std::int64_t steps;      ///< to take
    std::uint32_t size = 0;  ///< place of its Steps among those of all rows
};

/// Arrays of a device about its rows.
template <class Stepper>
struct RowArrays {
    const RowStart<Stepper>* starts;
    const typename Stepper::Steps* sizes;
    typename Stepper::State* states;
    LargestDeparture* energies;  ///< or null: not looked at
};

/// Puts row i where the scene begins.
template <class Stepper>
struct BeginRow {
    RowArrays<Stepper> rows;

    HVI_DEVICE void operator()(std::size_t i) const {
        const typename Stepper::Parameters& parameters = rows.starts[i].parameters;
        rows.states[i] = Stepper::initial(parameters);
        if (rows.energies == nullptr) { return; }
        const Stepper stepper(parameters);
        rows.energies[i] = {static_cast<double>(stepper.energy(rows.states[i])), 0};
    }
};

/// Adds row i to a list if its steps go on.
template <class Stepper>
struct ListRow {
    RowArrays<Stepper> rows;
    std::uint32_t* which;
    std::uint32_t* found;

    HVI_DEVICE void operator()(std::size_t i) const {
        const typename Stepper::State& x = rows.states[i];
        if (x.status != Status::Code::ok || x.steps >= rows.starts[i].steps) { return; }
        which[counted(found)] = static_cast<std::uint32_t>(i);
    }
};

/// Takes row i of a list `most` steps further, or up to its end.
template <class Stepper>
struct AdvanceRow {
    RowArrays<Stepper> rows;
    const std::uint32_t* which;
    std::int64_t most;

    HVI_DEVICE void operator()(std::size_t i) const {
        const std::uint32_t row = which[i];
        const RowStart<Stepper>& start = rows.starts[row];
        const typename Stepper::Steps& by = rows.sizes[start.size];
        const Stepper stepper(start.parameters);
        typename Stepper::State x = rows.states[row];
        const std::int64_t left = start.steps - x.steps, steps = left < most ? left : most;
        LargestDeparture energy;
        if (rows.energies != nullptr) { energy = rows.energies[row]; }
        for (std::int64_t step = 0; step < steps; ++step) {
            stepper.step(x, by);
            if (x.status != Status::Code::ok) { break; }
            if (rows.energies != nullptr) { energy.see(static_cast<double>(stepper.energy(x))); }
        }
        if (rows.energies != nullptr) { rows.energies[row] = energy; }
        rows.states[row] = x;
    }
};

}  // namespace hvi::device
