// Turn of a body about its own angular momentum.
// SPDX-License-Identifier: MIT
//
// NOTE: needs the standard library alone; see state.hpp.
#ifndef HVI_TURN_ABOUT_MOMENTUM_HPP
#define HVI_TURN_ABOUT_MOMENTUM_HPP

#include <array>
#include <cstddef>

#include <hvi/detail/numbers/math.hpp>
#include <hvi/detail/numbers/pair.hpp>

namespace hvi::detail {

namespace turn {

/// A quaternion (c, w L) of any size.
template <class Number>
struct Quaternion {
    Number c, w;

    /// Sets c = cos(s |L|) and w = sin(s |L|)/|L|, given L.L and s.
    Quaternion(const Number& square, const Number& s) : c(1), w(s) {
        if (square == 0) { return; }
        const Number size = math::sqrt(square);
        c = math::cos(s * size);
        w = math::sin(s * size) / size;
    }
};

/// Factors 2 c w/N and 2 w^2/N, where N = c^2 + w^2 L.L.
template <class Number>
struct Factors {
    Pair<Number> of_first, of_second;
};

/// Returns the factors of a quaternion that turns by 2 s |L|, given L.L and s.
template <class Number>
[[nodiscard]] Factors<Number> factors(const Pair<Number>& square, const Number& s) {
    const auto [c, w] = Quaternion<Number>(square.hi, s);
    const Pair<Number> w2 = two_product(w, w);
    const Pair<Number> norm = two_product(c, c) + w2 * square;
    const Number two_c = 2 * c;
    return {two_product(two_c, w) / norm, (w2 + w2) / norm};
}

/// Returns exp(hat(2 s L)) - 1, row by row.
template <class Number>
[[nodiscard]] std::array<Pair<Number>, 9> matrix(const std::array<Number, 3>& L, const Number& s) {
    const auto& [x, y, z] = L;
    const Pair<Number> xx = two_product(x, x), yy = two_product(y, y), zz = two_product(z, z);
    const Factors<Number> by = factors<Number>(xx + yy + zz, s);
    const auto across = [&](const Pair<Number>& a, const Pair<Number>& b) {
        return -(by.of_second * (a + b));
    };
    const Pair<Number> hat_x = by.of_first * Pair<Number>{x}, hat_y = by.of_first * Pair<Number>{y},
                       hat_z = by.of_first * Pair<Number>{z};
    const Pair<Number> xy = by.of_second * two_product(x, y), yz = by.of_second * two_product(y, z),
                       xz = by.of_second * two_product(x, z);
    return {across(yy, zz), xy - hat_z,     xz + hat_y,  //
            xy + hat_z,     across(xx, zz), yz - hat_x,  //
            xz - hat_y,     yz + hat_x,     across(xx, yy)};
}

/// Returns a.b, rounded once.
template <class Number>
[[nodiscard]] Number dot(const std::array<Number, 3>& a, const std::array<Pair<Number>, 3>& b) {
    Number sum = 0, rest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const Pair<Number> product = two_product(a[k], b[k].hi);
        const auto next = two_sum(sum, product.hi);
        sum = next.value;
        rest += (next.remainder + product.lo) + a[k] * b[k].lo;
    }
    return sum + rest;
}

}  // namespace turn

/// Returns R exp(hat(2 s L)) - R, row by row; given are R row by row, L, and s. With the quaternion
/// (c, w L) of any size it is (Rodrigues)
///
///     exp(hat(2 s L)) = 1 + 2 (c w hat(L) + w^2 hat(L)^2)/(c^2 + w^2 L.L).
///
/// NOTE: that is a rotation for any c and w, which thus may be rounded. All else has twice the
/// digits: L is the same in each step of a free body, and errors of rounding do not average out
/// then. Products with a matrix that is rounded made its axes grow by 1e-18 to 5e-17 a step.
template <class Number>
[[nodiscard]] std::array<Number, 9> turn_about_momentum(const std::array<Number, 13>& of) {
    const auto matrix = turn::matrix<Number>({of[9], of[10], of[11]}, of[12]);
    std::array<Number, 9> changes;
    for (std::size_t row = 0; row < 9; row += 3) {
        const std::array<Number, 3> from{of[row], of[row + 1], of[row + 2]};
        for (std::size_t k = 0; k < 3; ++k) {
            changes[row + k] = turn::dot<Number>(from, {matrix[k], matrix[k + 3], matrix[k + 6]});
        }
    }
    return changes;
}

}  // namespace hvi::detail

#endif  // HVI_TURN_ABOUT_MOMENTUM_HPP
