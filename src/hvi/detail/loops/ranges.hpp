// Indices that run from one whole number to another.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>

#include <hvi/detail/loops/stretch.hpp>

namespace hvi::detail {

/// How many there are from first to last.
[[nodiscard]] constexpr Place count_of(Place first, Place last) {
    return last < first ? 0 : last - first + 1;
}

/// i modulo n, from 0 to n - 1; 0 where n is not positive.
[[nodiscard]] constexpr Place remainder(Place i, Place n) {
    if (n <= 0) { return 0; }
    const Place rest = i % n;
    return rest < 0 ? rest + n : rest;
}

/// Gives to[0], to[1], ... these values.
template <class Scalar, std::size_t count>
void put(const Scalar (&values)[count], Scalar* to) {
    std::copy_n(values, count, to);
}

}  // namespace hvi::detail
