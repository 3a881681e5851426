// How the sums of moves on lattices round.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include <hvi/detail/loops/stretch.hpp>
#include <hvi/detail/numbers/compensated.hpp>

namespace hvi::detail {

/// Each sum is rounded.
template <class Scalar>
class PlainSums {
public:
    static constexpr std::size_t vectors = 0;    ///< of remainders
    static constexpr std::size_t registers = 2;  ///< of sites at once

    explicit PlainSums(Scalar*) {}

    /// x, which stands in place `at` of its vector, grows by the change.
    template <class V>
    HVI_INLINE_IN_LANES void add(V& x, const V& change, Place) const {
        x = x + change;
    }

    [[nodiscard]] static bool are_exact() { return true; }
};

/// What rounding cuts off from a sum is added to the next change of the same number.
template <class Scalar>
class CompensatedSums {
public:
    static constexpr std::size_t vectors = 1;
    // NOTE: of two, g++ 12 puts the parts of sums into memory, and takes four times as long.
    static constexpr std::size_t registers = 1;

    /// `remainders` are as many as the vector has numbers.
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
