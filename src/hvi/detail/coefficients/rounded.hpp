// One real number in each format.
// SPDX-License-Identifier: MIT
//
// NOTE: needs the standard library alone; see state.hpp.
#ifndef HVI_ROUNDED_HPP
#define HVI_ROUNDED_HPP

#include <hvi/detail/numbers/scalar.hpp>

namespace hvi::detail {

/// Returns the number of 24 bits, `single`, of 53 bits, `hi`, of 64 bits, hi + to_64, or of 113
/// bits, hi + (to_113 + rest). hvi-gen rounds each of them from the exact value, and writes them so
/// that these sums are exact. NOTE: literals of long double would be rounded once more where long
/// double is another format, and -std=c++17 refuses those of __float128.
template <class Scalar>
[[nodiscard]] constexpr Scalar
rounded([[maybe_unused]] float single, [[maybe_unused]] double hi, [[maybe_unused]] double to_64,
        [[maybe_unused]] double to_113, [[maybe_unused]] double rest) {
    static_assert(is_supported<Scalar>());
    if constexpr (bits<Scalar> == 24) {
        return static_cast<Scalar>(single);
    } else if constexpr (bits<Scalar> == 53) {
        return static_cast<Scalar>(hi);
    } else if constexpr (bits<Scalar> == 64) {
        return static_cast<Scalar>(hi) + static_cast<Scalar>(to_64);
    } else {
        return static_cast<Scalar>(hi) + (static_cast<Scalar>(to_113) + static_cast<Scalar>(rest));
    }
}

}  // namespace hvi::detail

#endif  // HVI_ROUNDED_HPP
