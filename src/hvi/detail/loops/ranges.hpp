// Indices that run from one whole number to another.
// SPDX-License-Identifier: MIT
#pragma once

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

/// Gives to[at], to[at + 1], ... these values, as far as there are places.
template <class Scalar, std::size_t count, class Vector>
void put(const Scalar (&values)[count], Vector& to, Place at) {
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t place = static_cast<std::size_t>(at) + k;
        if (place < to.size()) { to[place] = values[k]; }
    }
}

}  // namespace hvi::detail
