// How the sums of moves on lattices round.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include <hvi/detail/loops/stretch.hpp>
#include <hvi/detail/numbers/compensated.hpp>

namespace hvi::detail {

/// Plain sums, each of them rounded.
template <class Scalar>
class PlainSums {
public:
    static constexpr std::size_t vectors = 0;    ///< of remainders
    static constexpr std::size_t registers = 2;  ///< of sites at once

    explicit PlainSums(Scalar*) {}

    /// Adds the change to x, which stands in place `at` of its vector.
    template <class V>
    HVI_INLINE_IN_LANES void add(V& x, const V& change, Place) const {
        x = x + change;
    }

    [[nodiscard]] static bool are_exact() { return true; }
};

/// Compensated sums: the remainder of each sum is added to the next change of the same number.
template <class Scalar>
class CompensatedSums {
public:
    static constexpr std::size_t vectors = 1;
    // NOTE: with two registers g++ 12 puts the parts of sums into memory, and takes four times as
    // long.
    static constexpr std::size_t registers = 1;

    /// `remainders` points to as many numbers as the vector has.
    explicit CompensatedSums(Scalar* remainders) : remainders_(remainders) {}

    template <class V>
    HVI_INLINE_IN_LANES void add(V& x, const V& change, Place at) const {
        const Sum<V> sum = two_sum<V>(x, change + Stretch<V>::load(remainders_ + at));
        x = sum.value;
        Stretch<V>::store(sum.remainder, remainders_ + at);
    }

    [[nodiscard]] static bool are_exact() { return sums_are_exact<Scalar>(); }

private:
    Scalar* remainders_;
};

}  // namespace hvi::detail
