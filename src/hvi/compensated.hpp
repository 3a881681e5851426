// Compensated summation: sums that keep what rounding cuts off.
// SPDX-License-Identifier: MIT
#ifndef HVI_COMPENSATED_HPP
#define HVI_COMPENSATED_HPP

#include <cfloat>

// clang says nothing of -fassociative-math alone; sums_are_exact() finds that out at run time.
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__)
#error "hvi: -ffast-math and -fassociative-math destroy compensated summation: compile without"
#endif
#if FLT_EVAL_METHOD == 2 || FLT_EVAL_METHOD < 0
#error "hvi: needs double arithmetic that rounds to double after each operation: -mfpmath=sse"
#endif

namespace hvi {

/// A sum and what rounding cut off from it.
struct Sum {
    double value;
    double remainder;
};

/// a + b == value + remainder exactly, whatever the magnitudes (Knuth's TwoSum, free of branches).
/// Precondition: no overflow.
[[nodiscard]] constexpr Sum two_sum(double a, double b) {
    const double value = a + b;
    const double b_part = value - a;
    const double a_part = value - b_part;
    return {value, (a - a_part) + (b - b_part)};
}

namespace detail {

/// Whether two_sum() is what it says, or was compiled with reordered sums.
[[nodiscard]] inline bool sums_are_exact() {
    const volatile double large = 1.0;
    const volatile double small = 0x1p-60;
    const Sum sum = two_sum(large, small);
    return sum.value == 1.0 && sum.remainder == 0x1p-60;
}

}  // namespace detail
}  // namespace hvi

#endif  // HVI_COMPENSATED_HPP
