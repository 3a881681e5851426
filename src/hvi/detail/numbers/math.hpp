// The functions of <cmath>, for __float128 as well.
// SPDX-License-Identifier: MIT
//
// NOTE: needs the standard library alone; see state.hpp. The standard library has no functions of
// __float128. The libm of glibc has (sinf128, ..., since 2.26), nothing else is linked, and
// <math.h> declares them
//
//     to g++, also with -std=c++17: it always defines _GNU_SOURCE. With -U_GNU_SOURCE it does not.
//     to clang not in glibc 2.36.
//
// Where <math.h> declares them, it defines HUGE_VAL_F128, a macro of ISO/IEC TS 18661-3 and C23.
#ifndef HVI_MATH_HPP
#define HVI_MATH_HPP

#include <cmath>
#include <type_traits>

#include <hvi/detail/numbers/scalar.hpp>

/// Whether there are functions of __float128: 1 or 0.
#if defined(__SIZEOF_FLOAT128__) && defined(HUGE_VAL_F128)
#define HVI_HAS_FLOAT128 1
#else
#define HVI_HAS_FLOAT128 0
#endif

namespace hvi::math {

/// Widest numbers that steppers of scenes compute in: __float128 (113 bits, 33 digits) where
/// HVI_HAS_FLOAT128 is 1, else long double, whatever its format.
#if HVI_HAS_FLOAT128
__extension__ typedef __float128 Widest;  // NOTE: `using` would be warned of by -Wpedantic.
#else
using Widest = long double;
#endif

/// Whether there are functions of these numbers.
template <class Number>
inline constexpr bool computes_in = detail::is_standard<Number> || std::is_same_v<Number, Widest>;

// Functions that the H of a scene, its derivatives and the curve of a step may call.
using std::acos;
using std::asin;
using std::atan;
using std::cos;
using std::cosh;
using std::exp;
using std::expm1;
using std::log;
using std::pow;
using std::sin;
using std::sinh;
using std::sqrt;
using std::tan;
using std::tanh;

// Functions that the step of a quadratic H calls.
using std::islessgreater;
using std::isnormal;

#if HVI_HAS_FLOAT128
inline Widest acos(Widest x) { return ::acosf128(x); }
inline Widest asin(Widest x) { return ::asinf128(x); }
inline Widest atan(Widest x) { return ::atanf128(x); }
inline Widest cos(Widest x) { return ::cosf128(x); }
inline Widest cosh(Widest x) { return ::coshf128(x); }
inline Widest exp(Widest x) { return ::expf128(x); }
inline Widest expm1(Widest x) { return ::expm1f128(x); }
inline Widest log(Widest x) { return ::logf128(x); }
inline Widest pow(Widest x, Widest y) { return ::powf128(x, y); }
inline Widest sin(Widest x) { return ::sinf128(x); }
inline Widest sinh(Widest x) { return ::sinhf128(x); }
inline Widest sqrt(Widest x) { return ::sqrtf128(x); }
inline Widest tan(Widest x) { return ::tanf128(x); }
inline Widest tanh(Widest x) { return ::tanhf128(x); }
inline bool islessgreater(Widest x, Widest y) { return __builtin_islessgreater(x, y); }
inline bool isnormal(Widest x) { return __builtin_isnormal(x); }
#endif

}  // namespace hvi::math

#endif  // HVI_MATH_HPP
