// Departures of quantities that a run should keep.
// SPDX-License-Identifier: MIT
#pragma once

namespace hvi::detail {

/// How far a quantity has departed from what it was at the start.
struct Departure {
    double start = 0, largest = 0, last = 0;

    /// Compares a value with the start. NOTE: 0 is added so that none is -0; what is no number
    /// counts as large.
    void see(double value) {
        last = value + 0.0 - start;
        const double size = last < 0 ? -last : last;
        if (!(size <= largest)) { largest = size; }
    }
};

}  // namespace hvi::detail
