// Compensated summation: sums that keep what rounding cuts off.
// SPDX-License-Identifier: MIT
#ifndef HVI_COMPENSATED_HPP
#define HVI_COMPENSATED_HPP

#include <cfloat>

// clang does not define a macro for -fassociative-math alone; sums_are_exact() detects it at run
// time.
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__)
#error "hvi: -ffast-math and -fassociative-math destroy compensated summation: compile without"
#endif
#if FLT_EVAL_METHOD == 1 || FLT_EVAL_METHOD == 2 || FLT_EVAL_METHOD < 0
#error "hvi: needs arithmetic that rounds to its own type after each operation: -mfpmath=sse"
#endif

#include <hvi/detail/numbers/arithmetic.hpp>

namespace hvi {

/// A sum and its remainder, which rounding cut off.
template <class Scalar>
struct Sum {
    Scalar value;
    Scalar remainder;
};

/// Returns value + remainder == a + b exactly, whatever the magnitudes (Knuth's TwoSum, free of
/// branches). Precondition: no overflow.
template <class Scalar>
[[nodiscard]] constexpr Sum<Scalar> two_sum(Scalar a, Scalar b) {
    const Scalar value = a + b;
    const Scalar b_part = value - a;
    const Scalar a_part = value - b_part;
    return {value, (a - a_part) + (b - b_part)};
}

namespace detail {

/// Returns whether two_sum() is exact. It is not where sums were compiled to be reordered, or where
/// the processor is set to round otherwise.
template <class Scalar>
[[nodiscard]] bool sums_are_exact() {
    constexpr Scalar tiny = power_of_two<Scalar>(-bits<Scalar> - 7);
    const volatile Scalar large = 1;
    const volatile Scalar small = tiny;
    const Sum<Scalar> sum = two_sum<Scalar>(large, small);
    return sum.value == 1 && sum.remainder == tiny;
}

}  // namespace detail
}  // namespace hvi

#endif  // HVI_COMPENSATED_HPP
