// Turns of bodies side by side.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <type_traits>

#include <hvi/detail/groups/turn_about_momentum.hpp>
#include <hvi/detail/lanes/lane_math.hpp>
#include <hvi/detail/lanes/lane_pairs.hpp>
#include <hvi/detail/lanes/lanes.hpp>
#include <hvi/detail/numbers/small_turns.hpp>

namespace hvi {

namespace math {

// NOTE: the polynomials of one number, in registers, which give the same bits; see small_turns.hpp.

/// Returns tan y. Precondition: |y| <= 1/2 in the lanes that are looked at.
template <class Number, std::size_t count, std::size_t most>
[[nodiscard, gnu::always_inline]] inline Lanes<Number, count, most>
small_tan(const Lanes<Number, count, most>& y) {
    if constexpr (std::is_same_v<Number, double>) {
        return detail::tan_by_polynomial(y);
    } else {
        return math::tan(y);
    }
}

/// Returns sin 2y. Precondition: |y| <= 1/2 in the lanes that are looked at.
template <class Number, std::size_t count, std::size_t most>
[[nodiscard, gnu::always_inline]] inline Lanes<Number, count, most>
small_double_sin(const Lanes<Number, count, most>& y) {
    if constexpr (std::is_same_v<Number, double>) {
        return detail::double_sin_by_polynomial(y);
    } else {
        return math::sin(y + y);
    }
}

}  // namespace math

namespace detail::turn {

/// Quaternions of bodies side by side. NOTE: a body at rest takes w = s in its lane, where 0/0 is
/// computed too, and dropped.
template <class Number, std::size_t count, std::size_t most>
struct Quaternion<Lanes<Number, count, most>> {
    using Lane = Lanes<Number, count, most>;
    Lane c, w;

    Quaternion(const Lane& square, const Lane& s) {
        const Lane size = math::sqrt(square), half_angle = s * size;
        c = math::cos(half_angle);
        w = select(square == Lane(Number(0)), s, math::sin(half_angle) / size);
    }
};

}  // namespace detail::turn

}  // namespace hvi
