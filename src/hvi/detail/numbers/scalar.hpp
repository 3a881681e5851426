// The numbers that a stepper computes in: float, double, long double, or __float128.
// SPDX-License-Identifier: MIT
//
// NOTE: needs the standard library alone; see state.hpp. Of __float128 the standard library knows
// nothing under -std=c++17: what is needed stands here and in arithmetic.hpp, without libquadmath.
#ifndef HVI_SCALAR_HPP
#define HVI_SCALAR_HPP

#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

namespace hvi::detail {

/// What a vector holds, std::array's or Eigen's or a user's own: what its operator[] refers to, or
/// what it says itself by a specialisation.
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

/// The bits of the mantissa, the leading one included. They name the format, not the type does:
/// long double is one of 53, 64, 113 bits or a pair of doubles, as the machine has it.
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

/// Whether it may be a number: a class says so, and what its `bits` are, by specialisations.
template <class Scalar>
inline constexpr bool is_number = !std::is_class_v<Scalar>;

/// Whether there are coefficients for it: a floating-point number of 24, 53, 64 or 113 bits.
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
