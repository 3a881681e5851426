// Conditions on the coefficients of the general Galerkin form, met exactly in every format.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace hvi::detail {

/// Returns whether, without rounding, A_ij + D_ij == B_j for all entries and the sum of X_ij over i
/// is B_j. By the first, (4.6) is symplectic; by the second, it may be written with the P_i - p.
template <class Scalar, std::size_t r, std::size_t s>
[[nodiscard]] constexpr bool symplectic_curve(const Scalar (&X)[r][s], const Scalar (&A)[r][s],
                                              const Scalar (&D)[r][s], const Scalar (&B)[s]) {
    for (std::size_t j = 0; j < s; ++j) {
        Scalar rest = B[j];
        for (std::size_t i = 0; i < r; ++i) {
            // NOTE: both differences are needed: a sum that is B_j only after rounding fails one.
            if (B[j] - A[i][j] != D[i][j] || B[j] - D[i][j] != A[i][j]) { return false; }
            rest -= X[i][j];
        }
        if (rest != 0) { return false; }
    }
    return true;
}

}  // namespace hvi::detail
