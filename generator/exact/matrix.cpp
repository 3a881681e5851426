// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/matrix.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include "generator/exact/number_value.hpp"

namespace hvi::gen {

namespace {

/// row -= factor * pivot_row
void subtract_multiple(NumberVector& row, const Number& factor, const NumberVector& pivot_row) {
    for (std::size_t j = 0; j < row.size(); ++j) row[j] = row[j] - factor * pivot_row[j];
}

}  // namespace

NumberVector operator*(const NumberMatrix& matrix, const NumberVector& vector) {
    NumberVector result;
    for (const NumberVector& row : matrix) {
        Number sum;
        for (std::size_t j = 0; j < vector.size(); ++j) sum = sum + row[j] * vector[j];
        result.push_back(sum);
    }
    return result;
}

NumberMatrix transpose(const NumberMatrix& matrix) {
    NumberMatrix result(matrix.empty() ? 0 : matrix.front().size());
    for (const NumberVector& row : matrix) {
        for (std::size_t j = 0; j < row.size(); ++j) result[j].push_back(row[j]);
    }
    return result;
}

NumberMatrix operator*(const NumberMatrix& left, const NumberMatrix& right) {
    NumberMatrix columns;
    for (const NumberVector& column : transpose(right)) columns.push_back(left * column);
    return transpose(columns);
}

namespace {

/// The determinants of the first k columns and the k rows in `rows`, a set of bits, for all sets:
/// by their last columns.
NumberVector minors(const NumberMatrix& matrix) {
    const std::size_t s = matrix.size();
    NumberVector result(std::size_t{1} << s);
    result[0] = Number(1);
    for (std::size_t rows = 1; rows < result.size(); ++rows) {
        const auto k = static_cast<std::size_t>(std::popcount(rows));
        for (std::size_t row = 0, position = 0; row < s; ++row) {
            const std::size_t bit = std::size_t{1} << row;
            if ((rows & bit) == 0) { continue; }
            const Number term = matrix[row][k - 1] * result[rows ^ bit];
            result[rows] = (position + k) % 2 == 1 ? result[rows] + term : result[rows] - term;
            ++position;
        }
    }
    return result;
}

/// How many pairs of one element of each set stand in descending order.
std::size_t inversions(std::size_t left, std::size_t right) {
    std::size_t count = 0;
    for (; left != 0; left &= left - 1) {
        const std::size_t lowest = left & (~left + 1);
        count += static_cast<std::size_t>(std::popcount(right & (lowest - 1)));
    }
    return count;
}

/// The adjugate without a division: minors of the columns before and after one, by Laplace.
ScaledInverse by_minors(const NumberMatrix& matrix) {
    const std::size_t s = matrix.size();
    NumberMatrix reversed = matrix;
    for (NumberVector& row : reversed) { std::reverse(row.begin(), row.end()); }
    const NumberVector before = minors(matrix);
    const NumberVector after = minors(reversed);
    const std::size_t all = before.size() - 1;
    ScaledInverse result{NumberMatrix(s, NumberVector(s)), before[all]};
    for (std::size_t row = 0; row < s; ++row) {
        const std::size_t others = all ^ (std::size_t{1} << row);
        for (std::size_t left = 0; left <= all; ++left) {
            if ((left & ~others) != 0) { continue; }
            const auto column = static_cast<std::size_t>(std::popcount(left));
            if (column >= s) { continue; }
            const std::size_t right = others ^ left;
            const std::size_t count = s - 1 - column;  // of columns after it, which are reversed
            const std::size_t sign =
                row + column + inversions(left, right) + count * (count - 1) / 2;
            const Number term = before[left] * after[right];
            Number& entry = result.adjugate[column][row];
            entry = sign % 2 == 0 ? entry + term : entry - term;
        }
    }
    return result;
}

/// Whether elimination would divide by sums of generators, again and again.
bool has_generators(const NumberMatrix& matrix) {
    bool found = false;
    for (const NumberVector& row : matrix) {
        for (const Number& entry : row) {
            const Element* const element = entry.value().element();
            if (element == nullptr) { return false; }
            found = found || !element->is_rational();
        }
    }
    return found;
}

/// Gauss-Jordan elimination.
std::optional<NumberMatrix> by_elimination(const NumberMatrix& matrix) {
    const std::size_t s = matrix.size();
    NumberMatrix rows = matrix;  // [matrix | identity]
    for (std::size_t i = 0; i < s; ++i) {
        for (std::size_t j = 0; j < s; ++j) rows[i].push_back(Number(i == j ? 1 : 0));
    }
    for (std::size_t k = 0; k < s; ++k) {
        std::size_t pivot = k;
        while (pivot < s && rows[pivot][k].is_zero()) ++pivot;
        if (pivot == s) return std::nullopt;
        std::swap(rows[pivot], rows[k]);
        const Number scale = Number(1) / rows[k][k];
        for (Number& entry : rows[k]) entry = entry * scale;
        for (std::size_t i = 0; i < s; ++i) {
            if (i != k) subtract_multiple(rows[i], Number(rows[i][k]), rows[k]);
        }
    }
    for (NumberVector& row : rows) row.erase(row.begin(), row.begin() + static_cast<long>(s));
    return rows;
}

}  // namespace

std::optional<ScaledInverse> inverse(const NumberMatrix& matrix) {
    constexpr std::size_t most_rows = 8;  // the minors are 2^s
    if (matrix.size() <= most_rows && has_generators(matrix)) {
        ScaledInverse result = by_minors(matrix);
        if (result.determinant.is_zero()) { return std::nullopt; }
        return result;
    }
    auto result = by_elimination(matrix);
    if (!result) { return std::nullopt; }
    return ScaledInverse{*std::move(result), Number(1)};
}

std::optional<NumberVector> left_null_vector(const NumberMatrix& matrix) {
    // Row echelon form of [matrix | identity]: a row that vanishes on the left shows on the right
    // which combination of rows it is.
    const std::size_t count = matrix.size();
    const std::size_t columns = matrix.front().size();
    NumberMatrix rows = matrix;
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t j = 0; j < count; ++j) rows[i].push_back(Number(i == j ? 1 : 0));
    }
    std::size_t rank = 0;
    for (std::size_t column = 0; column < columns && rank < count; ++column) {
        std::size_t pivot = rank;
        while (pivot < count && rows[pivot][column].is_zero()) ++pivot;
        if (pivot == count) continue;
        std::swap(rows[pivot], rows[rank]);
        for (std::size_t i = rank + 1; i < count; ++i) {
            subtract_multiple(rows[i], rows[i][column] / rows[rank][column], rows[rank]);
        }
        ++rank;
    }
    if (rank == count) return std::nullopt;
    NumberVector combination(rows[rank].begin() + static_cast<long>(columns), rows[rank].end());
    std::size_t last = count;
    while (last-- > 0 && combination[last].is_zero()) {}
    const Number scale = Number(1) / combination.at(last);
    for (Number& entry : combination) entry = entry * scale;
    return combination;
}

}  // namespace hvi::gen
