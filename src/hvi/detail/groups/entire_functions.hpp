// The functions of an angle that rotations are made of.
// SPDX-License-Identifier: MIT
#pragma once

#include <hvi/detail/groups/space.hpp>
#include <hvi/detail/numbers/compensated.hpp>
#include <hvi/detail/numbers/math.hpp>
#include <hvi/detail/numbers/scalar.hpp>

namespace hvi::detail {

/// Stumpff's functions of the square y = x^2 of an angle,
///
///     c_k(y) = 1/k! - y/(k+2)! + y^2/(k+4)! - ...,
///
/// c_0 = cos x, c_1 = sin(x)/x, c_2 = (1 - cos x)/x^2, c_3 = (x - sin x)/x^3, and so on:
/// c_k = 1/k! - y c_{k+2}. They are entire, and 2 c_k' = k c_{k+2} - c_{k+1}.
template <class Value>
struct AngleFunctions {
    Value c1, c2, c3, c4, c5;
    Value c6, c7;  ///< for second derivatives
};

/// Type of the numbers that a value consists of, which is itself unless it holds several.
template <class Value>
struct NumberWithin {
    using type = Value;
};
template <class Value>
using NumberIn = typename NumberWithin<Value>::type;

namespace angles {

/// Value of y above which the functions are computed from sin and cos: each division by y then
/// loses one digit at most. Measured errors in double up to x = 2 pi: 6, 2, 4, 10 and 25 units in
/// the last place at most for c_2 to c_5 and 100 for the last two, and for c_1 one unit of 1.
inline constexpr double switch_at = 4;

/// Number of terms in a series of c_6 or c_7: switch_at^j 6!/(6 + 2j)! is below 2^-bits behind
/// them.
template <int bits>
inline constexpr int terms = bits <= 24   ? 6
                             : bits <= 53 ? 10
                             : bits <= 64 ? 11
                                          : 16;

/// Returns the quotient of the terms j and j - 1 of c_k, without -y.
template <class Value>
[[nodiscard]] constexpr Value quotient(int k, int j) {
    return Value(1) / static_cast<Value>((k + 2 * j - 1) * (k + 2 * j));
}

/// Returns the sum of every other term of c_k from the j-th on, divided by the j-th.
template <int k, int j, class Value>
HVI_INLINE_IN_SPACE [[nodiscard]] constexpr Value every_other(const Value& y2) {
    using Number = NumberIn<Value>;
    if constexpr (j + 2 > terms<bits<Number>>) {
        return Value(1);
    } else {
        const Number two_terms = quotient<Number>(k, j + 1) * quotient<Number>(k, j + 2);
        return Value(1) + y2 * two_terms * every_other<k, j + 2>(y2);
    }
}

/// Returns c_k of y <= switch_at, times k!. NOTE: terms of even and of odd powers are summed apart:
/// each sum is a chain of products, and a processor computes both chains at once.
template <int k, class Value>
HVI_INLINE_IN_SPACE [[nodiscard]] constexpr Value series(const Value& y) {
    const Value y2 = y * y;
    return every_other<k, 0>(y2) - y * quotient<NumberIn<Value>>(k, 1) * every_other<k, 1>(y2);
}

/// Returns 1/n as the nearest number, and its remainder, for n = odd * power of 2 where odd + 1 is
/// a power of 2 as well: the differences are then exact.
template <class Value>
HVI_INLINE_IN_SPACE [[nodiscard]] constexpr Sum<Value> inverse(int odd, int power) {
    const Value nearest = Value(1) / static_cast<Value>(odd);
    const Value cut_off = (Value(1) - static_cast<Value>(odd + 1) * nearest) + nearest;
    const auto n = static_cast<Value>(odd * power);
    return {Value(1) / n, cut_off / n};
}

/// Returns constant - x. NOTE: the remainder of the constant is added to x, where it is small
/// enough to count. Each difference is then rounded anew, and the roundings of many steps have a
/// mean of 0. Without the remainder all differences are off by the same third of a unit in the last
/// place, T has other derivatives than these functions, and the energy of a body drifts.
template <class Value>
HVI_INLINE_IN_SPACE [[nodiscard]] constexpr Value difference(const Sum<NumberIn<Value>>& constant,
                                                             const Value& x) {
    return constant.value - (x - constant.remainder);
}

/// Returns the functions by series: y <= switch_at.
template <class Value>
HVI_INLINE_IN_SPACE [[nodiscard]] inline AngleFunctions<Value> by_series(const Value& y) {
    using Number = NumberIn<Value>;
    AngleFunctions<Value> c;
    c.c6 = series<6>(y) / Value(720);
    c.c7 = series<7>(y) / Value(5040);
    c.c4 = difference(inverse<Number>(3, 8), y * c.c6);
    c.c5 = difference(inverse<Number>(15, 8), y * c.c7);
    c.c2 = Value(Number(1) / Number(2)) - y * c.c4;
    c.c3 = difference(inverse<Number>(3, 2), y * c.c5);
    c.c1 = Value(1) - y * c.c3;
    return c;
}

}  // namespace angles

template <class Value>
HVI_INLINE_IN_SPACE [[nodiscard]] inline AngleFunctions<Value> angle_functions(const Value& y) {
    if (!(y > Value(angles::switch_at))) { return angles::by_series(y); }
    AngleFunctions<Value> c;
    const Value half = math::sqrt(y) / Value(2);
    const Value sine = math::sin(half) / half;
    c.c1 = sine * math::cos(half);
    c.c2 = sine * sine / Value(2);
    c.c3 = (Value(1) - c.c1) / y;
    c.c4 = (Value(1) / Value(2) - c.c2) / y;
    c.c5 = (Value(1) / Value(6) - c.c3) / y;
    c.c6 = (Value(1) / Value(24) - c.c4) / y;
    c.c7 = (Value(1) / Value(120) - c.c5) / y;
    return c;
}

}  // namespace hvi::detail
