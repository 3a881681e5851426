// The potential between two argon atoms: a natural cubic spline through a table.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "argon_table.hpp"

/// On intervals of equal width. Its second derivatives at the knots, M_i, solve
/// M_{i-1} + 4 M_i + M_{i+1} = 6 (V_{i-1} - 2 V_i + V_{i+1})/width^2, and vanish at both ends.
class Spline {
public:
    static constexpr std::size_t knots = argon_table.size();
    static constexpr double first = 0.90, width = 0.02;

    Spline() {
        std::array<double, knots> below{};
        for (std::size_t i = 1; i + 1 < knots; ++i) {
            const double side =
                6 * (values_[i - 1] - 2 * values_[i] + values_[i + 1]) / (width * width);
            below[i] = 1 / (4 - below[i - 1]);
            second_[i] = (side - second_[i - 1]) * below[i];
        }
        for (std::size_t i = knots - 2; i > 0; --i) { second_[i] -= below[i] * second_[i + 1]; }
    }

    /// The polynomial of r's interval, or of the one at the end: its derivative of this order, with
    /// the values a and b and second derivatives A and B at the ends of the interval.
    template <int order, class X>
    [[nodiscard]] X at(const X& r) const {
        const X place = (r - X(first)) / X(width);
        std::size_t i = 0;
        while (i + 2 < knots && X(static_cast<double>(i + 1)) <= place) { ++i; }
        const X h = X(width), u = place - X(static_cast<double>(i)), v = X(1) - u;
        const X a = X(values_[i]), b = X(values_[i + 1]);
        const X A = X(second_[i]), B = X(second_[i + 1]);
        if constexpr (order == 0) {
            return v * a + u * b + ((v * v * v - v) * A + (u * u * u - u) * B) * h * h / X(6);
        } else if constexpr (order == 1) {
            return (b - a) / h + ((X(3) * u * u - X(1)) * B - (X(3) * v * v - X(1)) * A) * h / X(6);
        } else {
            return v * A + u * B;
        }
    }

private:
    const std::array<double, knots>& values_ = argon_table;
    std::array<double, knots> second_{};
};

inline const Spline spline;

// Functions that hvi calls, templates of one type of numbers: V and its first two derivatives.

template <class X>
X V(const X& r) {
    return spline.at<0>(r);
}
template <class X>
X V_1(const X& r) {
    return spline.at<1>(r);
}
template <class X>
X V_11(const X& r) {
    return spline.at<2>(r);
}
