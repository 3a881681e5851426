// The numbers of these tests, and how they are compared.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>

#include <hvi/detail/numbers/arithmetic.hpp>
#include <hvi/detail/numbers/math.hpp>

namespace float128 {

using hvi::math::Widest;

// NOTE: where there is no __float128 the same is tested of long double, to its own precision.
inline constexpr Widest eps = hvi::detail::epsilon<Widest>;
inline constexpr Widest eps_of_long_double = hvi::detail::epsilon<long double>;
inline constexpr bool is_quad = hvi::detail::bits<Widest> == 113;

/// A quotient of integers. NOTE: 0.1 is a double.
constexpr Widest ratio(int above, int below) { return Widest(above) / Widest(below); }

inline Widest pi() { return 4 * hvi::math::atan(Widest(1)); }

/// The arithmetic-geometric mean.
inline Widest mean(Widest a, Widest b) {
    while (hvi::detail::abs(a - b) > 4 * eps * a) {
        const Widest arithmetic = (a + b) / 2;
        b = hvi::math::sqrt(a * b);
        a = arithmetic;
    }
    return a;
}

/// For CHECK: Catch prints no __float128.
inline bool at_most(Widest value, Widest bound) { return value <= bound; }
inline bool near(Widest a, Widest b, Widest bound) { return hvi::detail::abs(a - b) <= bound; }

template <class State>
Widest distance(const State& x, const State& y) {
    Widest sum = 0;
    for (std::size_t k = 0; k < x.q.size(); ++k) {
        sum += hvi::detail::abs(x.q[k] - y.q[k]) + hvi::detail::abs(x.p[k] - y.p[k]);
    }
    return sum;
}

}  // namespace float128
