// Functions that few H call: the others of <cmath>, for __float128 as well, and those with kinks.
// SPDX-License-Identifier: MIT
#ifndef HVI_MORE_MATH_HPP
#define HVI_MORE_MATH_HPP

#include <cmath>
#include <type_traits>

#include <hvi/detail/numbers/math.hpp>

namespace hvi::math {

using std::acosh;
using std::asinh;
using std::atan2;
using std::atanh;
using std::cbrt;
using std::erf;
using std::erfc;
using std::log10;

#if HVI_HAS_FLOAT128
inline Widest acosh(Widest x) { return ::acoshf128(x); }
inline Widest asinh(Widest x) { return ::asinhf128(x); }
inline Widest atan2(Widest y, Widest x) { return ::atan2f128(y, x); }
inline Widest atanh(Widest x) { return ::atanhf128(x); }
inline Widest cbrt(Widest x) { return ::cbrtf128(x); }
inline Widest erf(Widest x) { return ::erff128(x); }
inline Widest erfc(Widest x) { return ::erfcf128(x); }
inline Widest log10(Widest x) { return ::log10f128(x); }
#endif

// Functions of one number, or of numbers side by side, for which a comparison is a mask. Number is
// named by the caller, so that arguments of other types are converted.

/// Returns `yes` where the mask is true, else `no`.
template <class Number, class Mask>
[[nodiscard]] constexpr Number chosen(const Mask& mask, const Number& yes, const Number& no) {
    if constexpr (std::is_same_v<Mask, bool>) {
        return mask ? yes : no;
    } else {
        return select(mask, yes, no);
    }
}

/// Returns x where a < b, else y: also where a or b is NaN.
template <class Number>
[[nodiscard]] constexpr Number if_less(const Number& a, const Number& b, const Number& x,
                                       const Number& y) {
    return chosen<Number>(a < b, x, y);
}

/// Returns x where a <= b, else y: also where a or b is NaN.
template <class Number>
[[nodiscard]] constexpr Number if_at_most(const Number& a, const Number& b, const Number& x,
                                          const Number& y) {
    return chosen<Number>(a <= b, x, y);
}

/// Returns the smaller number; NaN where a or b is NaN.
template <class Number>
[[nodiscard]] constexpr Number min(const Number& a, const Number& b) {
    return if_less<Number>(a, b, a, if_at_most<Number>(b, a, b, a + b));
}

/// Returns the larger number; NaN where a or b is NaN.
template <class Number>
[[nodiscard]] constexpr Number max(const Number& a, const Number& b) {
    return if_less<Number>(b, a, a, if_at_most<Number>(a, b, b, a + b));
}

template <class Number>
[[nodiscard]] constexpr Number abs(const Number& x) {
    const Number zero(0);
    return if_less<Number>(zero, x, x, zero - x);
}

/// Returns -1, 0 or 1; NaN for NaN.
template <class Number>
[[nodiscard]] constexpr Number sign(const Number& x) {
    const Number zero(0), one(1);
    return if_less<Number>(zero, x, one, if_less<Number>(x, zero, -one, x - x));
}

}  // namespace hvi::math

#endif  // HVI_MORE_MATH_HPP
