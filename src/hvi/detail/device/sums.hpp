// Sums of numbers of a device that keep what rounding cuts off.
// SPDX-License-Identifier: MIT
#pragma once

#include <hvi/detail/device/real.hpp>

namespace hvi::device {

/// A sum and its remainder; see hvi::Sum.
template <class Number>
struct Sum {
    Real<Number> value, remainder;
};

/// Returns value + remainder == a + b exactly; see hvi::two_sum().
template <class Number>
[[nodiscard]] HVI_DEVICE constexpr Sum<Number> two_sum(Real<Number> a, Real<Number> b) {
    const Real<Number> value = a + b;
    const Real<Number> b_part = value - a;
    const Real<Number> a_part = value - b_part;
    return {value, (a - a_part) + (b - b_part)};
}

}  // namespace hvi::device
