// Departures of quantities that a run should keep.
// SPDX-License-Identifier: MIT
#pragma once

namespace hvi::detail {

/// Distance of a quantity from its value at the start.
struct Departure {
    double start = 0, largest = 0, last = 0;
    double looks = 0, sum = 0, moment = 0;  ///< number n, sum of the distances d_n, sum of n d_n

    /// Compares a value with the start. NOTE: 0 is added so that no distance is -0; a NaN counts as
    /// large.
    void see(double value) {
        last = value + 0.0 - start;
        const double size = last < 0 ? -last : last;
        if (!(size <= largest)) { largest = size; }
        ++looks;
        sum += last;
        moment += looks * last;
    }

    /// Returns the slope of the line that fits the start and all distances best, by least squares:
    /// its rise from one look to the next.
    [[nodiscard]] double slope() const {
        if (looks == 0) { return 0; }
        return 12 * (moment - looks / 2 * sum) / (looks * (looks + 1) * (looks + 2));
    }
};

}  // namespace hvi::detail
