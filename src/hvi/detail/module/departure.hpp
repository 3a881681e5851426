// Departures of quantities that a run should keep.
// SPDX-License-Identifier: MIT
#pragma once

namespace hvi::detail {

/// Distance of a quantity from its value at the start.
struct Departure {
    double start = 0, largest = 0, last = 0;

    /// Compares a value with the start. NOTE: 0 is added so that no distance is -0; a NaN counts as
    /// large.
    void see(double value) {
        last = value + 0.0 - start;
        const double size = last < 0 ? -last : last;
        if (!(size <= largest)) { largest = size; }
    }
};

}  // namespace hvi::detail
