// Adjugate and determinant of a small matrix over a ring: sums of products, no division.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <vector>

namespace hvi::gen {

template <class Ring>
using SquareMatrix = std::vector<std::vector<Ring>>;  ///< rows

/// Returns the determinants of the first k columns and the k rows in `rows`, a set of bits, for all
/// sets, by expansion along their last columns.
template <class Ring>
[[nodiscard]] std::vector<Ring> minors(const SquareMatrix<Ring>& matrix) {
    const std::size_t s = matrix.size();
    std::vector<Ring> result(std::size_t{1} << s);
    result[0] = Ring(1);
    for (std::size_t rows = 1; rows < result.size(); ++rows) {
        const auto k = static_cast<std::size_t>(std::popcount(rows));
        for (std::size_t row = 0, position = 0; row < s; ++row) {
            const std::size_t bit = std::size_t{1} << row;
            if ((rows & bit) == 0) { continue; }
            const Ring term = matrix[row][k - 1] * result[rows ^ bit];
            result[rows] = (position + k) % 2 == 1 ? result[rows] + term : result[rows] - term;
            ++position;
        }
    }
    return result;
}

/// Returns how many pairs of one element of each set stand in descending order.
[[nodiscard]] inline std::size_t inversions(std::size_t left, std::size_t right) {
    std::size_t count = 0;
    for (; left != 0; left &= left - 1) {
        const std::size_t lowest = left & (~left + 1);
        count += static_cast<std::size_t>(std::popcount(right & (lowest - 1)));
    }
    return count;
}

template <class Ring>
struct Adjugate {
    SquareMatrix<Ring> adjugate;  ///< the matrix times it is the determinant times the identity
    Ring determinant;
};

/// Returns adjugate and determinant from the minors of the columns before and after one, by
/// Laplace. Takes about s 2^s products.
template <class Ring>
[[nodiscard]] Adjugate<Ring> by_minors(const SquareMatrix<Ring>& matrix) {
    const std::size_t s = matrix.size();
    SquareMatrix<Ring> reversed = matrix;
    for (auto& row : reversed) { std::reverse(row.begin(), row.end()); }
    const std::vector<Ring> before = minors(matrix);
    const std::vector<Ring> after = minors(reversed);
    const std::size_t all = before.size() - 1;
    Adjugate<Ring> result{SquareMatrix<Ring>(s, std::vector<Ring>(s)), before[all]};
    for (std::size_t row = 0; row < s; ++row) {
        const std::size_t others = all ^ (std::size_t{1} << row);
        for (std::size_t left = 0; left < all; ++left) {
            if ((left & ~others) != 0) { continue; }
            const auto column = static_cast<std::size_t>(std::popcount(left));
            const std::size_t right = others ^ left;
            const std::size_t count = s - 1 - column;  // of later columns, which are reversed
            const std::size_t sign =
                row + column + inversions(left, right) + (count == 0 ? 0 : count * (count - 1) / 2);
            const Ring term = before[left] * after[right];
            Ring& entry = result.adjugate[column][row];
            entry = sign % 2 == 0 ? entry + term : entry - term;
        }
    }
    return result;
}

}  // namespace hvi::gen
