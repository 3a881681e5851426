// Random numbers in each scalar.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <random>

#include <hvi/detail/numbers/arithmetic.hpp>
#include <hvi/detail/numbers/pair.hpp>

#include "tests/runtime/scalars/scalars.hpp"

namespace parameter {

#ifdef __SIZEOF_FLOAT128__
#define HVI_WORK_SCALARS double, long double, scalars::Quad
#else
#define HVI_WORK_SCALARS double, long double
#endif

/// Numbers with all their bits drawn.
class Numbers {
public:
    explicit Numbers(unsigned seed) : generator_(seed) {}

    /// In [-1, 1).
    template <class S>
    S unit() {
        S sum = 0;
        S weight = 1;
        for (int i = 0; i < 4; ++i) {
            weight /= S(1U << 31);
            sum += weight * S(generator_() >> 1);
        }
        return 2 * sum - 1;
    }

    /// In [from, to).
    double between(double from, double to) {
        return std::uniform_real_distribution<double>(from, to)(generator_);
    }

    /// Returns a number of any sign, with a magnitude from 2^from to 2^to, and a low part of full
    /// size.
    template <class S>
    hvi::detail::Pair<S> pair(int from, int to) {
        const auto exponent =
            static_cast<int>(generator_() % static_cast<unsigned>(to - from + 1)) + from;
        return scaled(normal<S>(unit<S>()), exponent);
    }

    /// A number and a low part that fits.
    template <class S>
    hvi::detail::Pair<S> normal(S hi) {
        const S lo = hi * unit<S>() * hvi::detail::epsilon<S> / 4;
        return hvi::detail::pair(hvi::two_sum(hi, hvi::detail::opaque(lo)));
    }

    template <class S>
    static hvi::detail::Pair<S> scaled(hvi::detail::Pair<S> a, int exponent) {
        const S factor = hvi::detail::two_to_the<S>(exponent);
        return {a.hi * factor, a.lo * factor};
    }

private:
    std::mt19937 generator_;
};

}  // namespace parameter
