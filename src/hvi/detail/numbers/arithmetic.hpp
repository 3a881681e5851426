// Arithmetic of solvers on the numbers of scalar.hpp.
// SPDX-License-Identifier: MIT
//
// NOTE: needs the standard library alone; see state.hpp.
#ifndef HVI_ARITHMETIC_HPP
#define HVI_ARITHMETIC_HPP

#include <cmath>
#include <limits>

#include <hvi/detail/numbers/scalar.hpp>

namespace hvi::detail {

/// Returns 2^exponent, for exponents that are not positive.
template <class Scalar>
[[nodiscard]] constexpr Scalar power_of_two(int exponent) {
    Scalar power = 1;
    for (; exponent < 0; ++exponent) { power /= 2; }
    return power;
}

/// Distance from 1 to the next number.
template <class Scalar>
inline constexpr Scalar epsilon = power_of_two<Scalar>(1 - bits<Scalar>);

template <class Scalar>
inline constexpr auto infinity = static_cast<Scalar>(std::numeric_limits<float>::infinity());

template <class Scalar>
[[nodiscard]] inline Scalar abs(Scalar x) {
    if constexpr (is_standard<Scalar>) {
        return std::abs(x);
    } else {
        return x < 0 ? -x : x;
    }
}

/// Returns the larger number, or the other one of a NaN.
template <class Scalar>
[[nodiscard]] inline Scalar larger(Scalar a, Scalar b) {
    if constexpr (is_standard<Scalar>) {
        // NOTE: not a comparison, with which g++ 12 lays out the loops around it so that a step of
        // gauss:2 takes a tenth longer.
        return std::fmax(a, b);
    } else {
        return a < b || a != a ? b : a;
    }
}

}  // namespace hvi::detail

#endif  // HVI_ARITHMETIC_HPP
