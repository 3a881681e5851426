// What becomes of a quantity that a run should keep.
// SPDX-License-Identifier: MIT
#pragma once

namespace hvi::detail {

/// How far a quantity has departed from what it was at the start.
struct Departure {
    double start = 0, largest = 0, last = 0;

    /// NOTE: a sum with 0, so that none is -0; and what is no number counts as large.
    void see(double value) {
        last = value + 0.0 - start;
        const double size = last < 0 ? -last : last;
        if (!(size <= largest)) { largest = size; }
    }
};

}  // namespace hvi::detail
