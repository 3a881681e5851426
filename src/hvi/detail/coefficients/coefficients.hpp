// Conditions on the coefficients of a symplectic method, met exactly in every format.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace hvi::detail {

/// Returns whether m_ij + mt_ji == 1 for all entries and without rounding: b_i a~_ij + b_j a_ji =
/// b_i b_j divided by b_i b_j, the condition for (4.18) to be symplectic.
template <class Scalar, std::size_t r, std::size_t s>
[[nodiscard]] constexpr bool complementary(const Scalar (&m)[r][s], const Scalar (&mt)[s][r]) {
    for (std::size_t i = 0; i < r; ++i) {
        for (std::size_t j = 0; j < s; ++j) {
            // NOTE: both differences are needed: a sum that is 1 only after rounding fails one.
            if (1 - m[i][j] != mt[j][i] || 1 - mt[j][i] != m[i][j]) { return false; }
        }
    }
    return true;
}

/// Returns whether n_ij - n_ji == c_i - c_j for all entries and without rounding: the condition for
/// a Nystrom method to be symplectic, divided by its weights.
template <class Scalar, std::size_t r>
[[nodiscard]] constexpr bool symplectic(const Scalar (&c)[r], const Scalar (&n)[r][r]) {
    for (std::size_t i = 0; i < r; ++i) {
        for (std::size_t j = 0; j < r; ++j) {
            const Scalar difference = c[i] - c[j];
            if (n[i][j] - n[j][i] != difference || n[i][j] - difference != n[j][i] ||
                n[j][i] + difference != n[i][j]) {
                return false;
            }
        }
    }
    return true;
}

}  // namespace hvi::detail
