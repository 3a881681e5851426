// Indices that run from one whole number to another.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <vector>

#include <hvi/detail/loops/stretch.hpp>

namespace hvi::detail {

/// Returns the number of indices from first to last.
[[nodiscard]] constexpr Place count_of(Place first, Place last) {
    return last < first ? 0 : last - first + 1;
}

/// Returns i modulo n, from 0 to n - 1; 0 where n is not positive.
[[nodiscard]] constexpr Place remainder(Place i, Place n) {
    if (n <= 0) { return 0; }
    const Place rest = i % n;
    return rest < 0 ? rest + n : rest;
}

// NOTE: the following functions are called and not inlined. Where g++ 12.2 sees which constants are
// copied, it may write 1, 1, 1, 1 for 1, 1, 0, 0 on processors with AVX-512, its bug 108599.

/// Returns the values as a list of Parameters.
template <class Scalar>
[[nodiscard, gnu::noinline]] std::vector<Scalar> listed(std::initializer_list<Scalar> values) {
    return values;
}

/// Copies the values to to[0], to[1], ...
template <class Scalar, std::size_t count>
[[gnu::noinline]] void put(const Scalar (&values)[count], Scalar* to) {
    std::copy_n(values, count, to);
}

}  // namespace hvi::detail
