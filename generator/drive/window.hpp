// Products of samples with cosines and sines, under a window.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace hvi::gen {

/// Calls see(k, c, s) with the cosine and sine of frequency (first + k), for k from 0 on.
///
/// NOTE: repeated turns accumulate rounding errors, so each block begins anew. The product of a
/// frequency and a time needs more digits than a double has, since only its remainder counts.
template <class See>
void for_each_turn(double frequency, double first, std::size_t count, See see) {
    constexpr std::size_t block = 64;
    const double turn_c = std::cos(frequency), turn_s = std::sin(frequency);
    for (std::size_t begin = 0; begin < count; begin += block) {
        const long double angle = static_cast<long double>(frequency) *
                                  static_cast<long double>(first + static_cast<double>(begin));
        auto c = static_cast<double>(std::cos(angle)), s = static_cast<double>(std::sin(angle));
        const std::size_t end = std::min(begin + block, count);
        for (std::size_t k = begin; k < end; ++k) {
            see(k, c, s);
            const double next = c * turn_c - s * turn_s;
            s = s * turn_c + c * turn_s;
            c = next;
        }
    }
}

/// Sums over samples at times tau = ..., -1, 0, 1, ... (or halves), whose middle is 0, with the
/// weights (1 + cos(2 pi tau/N))/N, whose sum is 1. Frequencies are in radians per sample.
class HanningWindow {
public:
    explicit HanningWindow(std::size_t count);

    [[nodiscard]] std::size_t count() const { return count_; }
    /// Returns the time of a sample.
    [[nodiscard]] double time(std::size_t k) const {
        return static_cast<double>(k) - static_cast<double>(count_ - 1) / 2;
    }
    [[nodiscard]] double weight(std::size_t k) const;

    /// Returns the sum of the weights times cos(frequency tau), and its derivative.
    [[nodiscard]] double transform(double frequency) const;
    [[nodiscard]] double transform_slope(double frequency) const;

private:
    std::size_t count_;
};

/// A function that is projected onto cosines and sines.
class WindowedSamples {
public:
    WindowedSamples(const HanningWindow& window, std::span<const double> values);

    /// Products with cos and sin, and their derivatives by the frequency.
    struct Products {
        double cosine = 0, sine = 0, cosine_slope = 0, sine_slope = 0;
    };
    [[nodiscard]] Products products(double frequency) const;

private:
    double first_;                    ///< time of the first of the pairs
    std::vector<double> even_, odd_;  ///< parts under the window, at times above 0
};

}  // namespace hvi::gen
