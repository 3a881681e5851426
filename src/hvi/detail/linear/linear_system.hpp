// Linear equations in numbers of twice the digits.
// SPDX-License-Identifier: MIT
//
// NOTE: needs the standard library alone; see state.hpp.
#ifndef HVI_LINEAR_SYSTEM_HPP
#define HVI_LINEAR_SYSTEM_HPP

#include <array>
#include <cstddef>
#include <utility>

#include <hvi/detail/numbers/arithmetic.hpp>
#include <hvi/detail/numbers/pair.hpp>
#include <hvi/detail/numbers/scalar.hpp>

namespace hvi::detail {

/// N linear equations with several right sides.
template <class Scalar, std::size_t N, std::size_t columns>
class LinearSystem {
public:
    using Number = Pair<Scalar>;

    std::array<std::array<Number, N + columns>, N> rows{};  ///< the matrix, then the right sides

    /// Replaces the right sides by the solutions (Gauss with row pivots). Returns false where the
    /// matrix is singular, or not finite.
    [[nodiscard]] bool solve() {
        for (std::size_t k = 0; k < N; ++k) {
            std::size_t pivot = k;
            for (std::size_t i = k + 1; i < N; ++i) {
                if (abs(rows[i][k].hi) > abs(rows[pivot][k].hi)) { pivot = i; }
            }
            std::swap(rows[k], rows[pivot]);
            if (rows[k][k].hi == 0 || !is_finite(rows[k][k].hi)) { return false; }
            for (std::size_t i = 0; i < N; ++i) {
                if (i != k && rows[i][k].hi != 0) { eliminate(k, i); }
            }
        }
        for (std::size_t k = 0; k < N; ++k) {
            for (std::size_t j = N; j < N + columns; ++j) { rows[k][j] = rows[k][j] / rows[k][k]; }
        }
        return true;
    }

private:
    void eliminate(std::size_t k, std::size_t i) {
        const Number factor = rows[i][k] / rows[k][k];
        for (std::size_t j = k; j < N + columns; ++j) {
            rows[i][j] = rows[i][j] - factor * rows[k][j];
        }
    }
};

}  // namespace hvi::detail

#endif  // HVI_LINEAR_SYSTEM_HPP
