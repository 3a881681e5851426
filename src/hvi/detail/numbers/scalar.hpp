// The numbers that a stepper computes in: float, double, long double, or __float128.
// SPDX-License-Identifier: MIT
//
// NOTE: needs the standard library alone; see state.hpp. Under -std=c++17 the standard library
// knows nothing of __float128: what is needed stands here and in arithmetic.hpp, without
// libquadmath.
#ifndef HVI_SCALAR_HPP
#define HVI_SCALAR_HPP

#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

namespace hvi::detail {

/// Type of the numbers in a vector of std::array, Eigen or a user. It is the type that operator[]
/// refers to, unless a specialisation names another one.
template <class Vector>
struct HeldBy {
    using type = std::remove_reference_t<decltype(std::declval<Vector&>()[0])>;
};
template <class Vector>
using ScalarOf = typename HeldBy<Vector>::type;

/// Whether the standard library computes with it.
template <class Scalar>
inline constexpr bool is_standard =
    std::is_same_v<Scalar, float> || std::is_same_v<Scalar, double> ||
    std::is_same_v<Scalar, long double>;

/// Returns the bits of the mantissa, the leading one included. They name the format, which the type
/// does not: long double has 53, 64 or 113 bits or is a pair of doubles, depending on the machine.
template <class Scalar>
[[nodiscard]] constexpr int count_bits() {
    if constexpr (std::numeric_limits<Scalar>::is_specialized) {
        return std::numeric_limits<Scalar>::digits;
    } else {
        int count = 0;
        for (Scalar power = 1; (power + Scalar(1)) - power == Scalar(1); power += power) {
            ++count;
        }
        return count;
    }
}

template <class Scalar>
inline constexpr int bits = count_bits<Scalar>();

/// Whether a type may be a number. A class is one by a specialisation, with one of `bits`.
template <class Scalar>
inline constexpr bool is_number = !std::is_class_v<Scalar>;

/// Returns whether there are coefficients for a type: a floating-point number of 24, 53, 64 or 113
/// bits.
template <class Scalar>
[[nodiscard]] constexpr bool is_supported() {
    if constexpr (!is_number<Scalar> || std::is_const_v<Scalar> ||
                  std::numeric_limits<Scalar>::is_integer) {
        return false;
    } else {
        return bits<Scalar> == 24 || bits<Scalar> == 53 || bits<Scalar> == 64 ||
               bits<Scalar> == 113;
    }
}

template <class Scalar>
[[nodiscard]] constexpr bool is_finite(Scalar x) {
    if constexpr (is_standard<Scalar>) {
        return std::isfinite(x);
    } else {
        return x - x == 0;
    }
}

}  // namespace hvi::detail

#endif  // HVI_SCALAR_HPP
