// A point plus an increment: the one place that knows that the space is flat.
// SPDX-License-Identifier: MIT
#pragma once

#include <hvi/detail/numbers/compensated.hpp>

namespace hvi::detail {

/// Returns the point plus an increment, both numbers or lanes. The increment includes what rounding
/// has cut off from the point before.
template <class Point, class Increment>
[[nodiscard, gnu::always_inline]] constexpr auto moved(const Point& point,
                                                       const Increment& increment) {
    return point + increment;
}

/// Moves the point by `remainder + increment`; the remainder keeps what rounding cuts off.
template <class Scalar>
constexpr void move(Scalar& point, Scalar& remainder, Scalar increment) {
    const Sum<Scalar> sum = two_sum(point, remainder + increment);
    point = sum.value;
    remainder = sum.remainder;
}

}  // namespace hvi::detail
