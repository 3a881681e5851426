// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/algebra/matrix.hpp"

#include <algorithm>
#include <utility>

#include "generator/exact/algebra/rational_matrix.hpp"
#include "generator/exact/numbers/minors.hpp"
#include "generator/exact/numbers/number_value.hpp"
#include "generator/exact/numbers/rational.hpp"

namespace hvi::gen {

namespace {

/// Sets row -= factor * pivot_row.
void subtract_multiple(NumberVector& row, const Number& factor, const NumberVector& pivot_row) {
    for (std::size_t j = 0; j < row.size(); ++j) row[j] = row[j] - factor * pivot_row[j];
}

}  // namespace

namespace {

/// Returns sum_j left_j right_j. NOTE: where enclosures are involved it is one node of their graph,
/// not a product and a sum for each j; factors 0 and 1 keep their exact meaning.
Number dot(const NumberVector& left, const NumberVector& right) {
    NumberVector a, b;
    for (std::size_t j = 0; j < left.size(); ++j) {
        const bool is_zero = is_exactly(left[j], 0) || is_exactly(right[j], 0);
        if (is_zero) { continue; }
        a.push_back(left[j]);
        b.push_back(right[j]);
    }
    const auto is_element = [](const Number& entry) { return entry.value().element() != nullptr; };
    if (a.size() < 2 || (std::all_of(a.begin(), a.end(), is_element) &&
                         std::all_of(b.begin(), b.end(), is_element))) {
        Number sum;
        for (std::size_t j = 0; j < a.size(); ++j) { sum = sum + a[j] * b[j]; }
        return sum;
    }
    return number(Real([a = std::move(a), b = std::move(b)](Precision bits) {
        Ball sum;
        for (std::size_t j = 0; j < a.size(); ++j) {
            arb_addmul(sum.get(), enclosure(a[j], bits).get(), enclosure(b[j], bits).get(), bits);
        }
        return sum;
    }));
}

bool is_rational(const NumberVector& vector) {
    return std::all_of(vector.begin(), vector.end(), [](const Number& entry) {
        const Element* const element = entry.value().element();
        return element != nullptr && element->is_rational();
    });
}

bool is_rational(const NumberMatrix& matrix) {
    return std::all_of(matrix.begin(), matrix.end(),
                       [](const NumberVector& row) { return is_rational(row); });
}

/// Returns the product, computed by FLINT, which sums without a division for each term; the right
/// factor is given by its columns. Precondition: all entries are rational.
NumberMatrix rational_product(const NumberMatrix& matrix, const NumberMatrix& columns) {
    const std::size_t inner = columns.front().size();
    RationalMatrix left(matrix.size(), inner);
    RationalMatrix right(inner, columns.size());
    RationalMatrix product(matrix.size(), columns.size());
    for (std::size_t k = 0; k < inner; ++k) {
        for (std::size_t i = 0; i < matrix.size(); ++i) {
            matrix[i][k].value().element()->copy_to(left.entry(i, k));
        }
        for (std::size_t j = 0; j < columns.size(); ++j) {
            columns[j][k].value().element()->copy_to(right.entry(k, j));
        }
    }
    fmpq_mat_mul(product.get(), left.get(), right.get());
    NumberMatrix result(matrix.size());
    for (std::size_t i = 0; i < matrix.size(); ++i) {
        for (std::size_t j = 0; j < columns.size(); ++j) {
            result[i].push_back(number(Element::copy_of(product.entry(i, j)), nullptr));
        }
    }
    return result;
}

/// Returns matrix * right, where the right factor is given by its columns.
NumberMatrix product(const NumberMatrix& matrix, const NumberMatrix& columns) {
    if (!columns.empty() && is_rational(columns) && is_rational(matrix)) {
        return rational_product(matrix, columns);
    }
    NumberMatrix result;
    for (const NumberVector& row : matrix) {
        NumberVector& entries = result.emplace_back();
        for (const NumberVector& column : columns) { entries.push_back(dot(row, column)); }
    }
    return result;
}

}  // namespace

NumberVector operator*(const NumberMatrix& matrix, const NumberVector& vector) {
    NumberVector result;
    for (const NumberVector& row : product(matrix, {vector})) { result.push_back(row.front()); }
    return result;
}

NumberVector operator*(const NumberVector& vector, const Number& factor) {
    NumberVector result;
    for (const Number& entry : vector) { result.push_back(entry * factor); }
    return result;
}

Number without_closed_form(const Number& value) {
    if (is_exactly(value, 0) || is_exactly(value, 1)) { return value; }
    return number(Real([value](Precision bits) { return enclosure(value, bits); }));
}

NumberVector without_closed_form(const NumberVector& numbers) {
    NumberVector result;
    for (const Number& entry : numbers) { result.push_back(without_closed_form(entry)); }
    return result;
}

NumberMatrix without_closed_form(const NumberMatrix& rows) {
    NumberMatrix result;
    for (const NumberVector& row : rows) { result.push_back(without_closed_form(row)); }
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
    return product(left, transpose(right));
}

NumberMatrix operator+(const NumberMatrix& left, const NumberMatrix& right) {
    NumberMatrix sum = left;
    for (std::size_t i = 0; i < sum.size(); ++i) {
        for (std::size_t j = 0; j < sum[i].size(); ++j) { sum[i][j] = sum[i][j] + right[i][j]; }
    }
    return sum;
}

NumberMatrix operator*(const NumberMatrix& matrix, const Number& factor) {
    NumberMatrix result;
    for (const NumberVector& row : matrix) { result.push_back(row * factor); }
    return result;
}

NumberMatrix identity(std::size_t size) {
    NumberMatrix result = zeros(size, size);
    for (std::size_t i = 0; i < size; ++i) { result[i][i] = Number(1); }
    return result;
}

NumberMatrix zeros(std::size_t height, std::size_t width) {
    return NumberMatrix(height, NumberVector(width));
}

bool is_zero(const NumberMatrix& matrix) {
    return std::all_of(matrix.begin(), matrix.end(), [](const NumberVector& row) {
        return std::all_of(row.begin(), row.end(), [](const Number& n) { return n.is_zero(); });
    });
}

bool is_table(const NumberMatrix& matrix, std::size_t height, std::size_t width) {
    return matrix.size() == height &&
           std::all_of(matrix.begin(), matrix.end(),
                       [&](const NumberVector& row) { return row.size() == width; });
}

NumberMatrix rows(const NumberMatrix& matrix, std::size_t first, std::size_t last) {
    return {matrix.begin() + static_cast<long>(first), matrix.begin() + static_cast<long>(last)};
}

NumberMatrix stacked(NumberMatrix upper, const NumberMatrix& lower) {
    upper.insert(upper.end(), lower.begin(), lower.end());
    return upper;
}

NumberMatrix beside(NumberMatrix left, const NumberMatrix& right) {
    for (std::size_t i = 0; i < left.size(); ++i) {
        left[i].insert(left[i].end(), right[i].begin(), right[i].end());
    }
    return left;
}

NumberMatrix kronecker(const NumberMatrix& left, const NumberMatrix& right) {
    NumberMatrix result;
    for (const NumberVector& left_row : left) {
        for (const NumberVector& right_row : right) {
            NumberVector& row = result.emplace_back();
            for (const Number& factor : left_row) {
                for (const Number& entry : right_row) { row.push_back(factor * entry); }
            }
        }
    }
    return result;
}

namespace {

/// Returns whether elimination would divide by sums of generators, again and again.
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

/// Returns the row from k on whose entry in column k is divided by; empty where all of them are
/// zero. NOTE: exact entries come first. They eliminate exactly, so that the inverse has zeros
/// where enclosures would leave the question open.
std::optional<std::size_t> pivot_row(const NumberMatrix& rows, std::size_t k) {
    for (std::size_t i = k; i < rows.size(); ++i) {
        if (is_exact(rows[i][k]) && !rows[i][k].is_zero()) { return i; }
    }
    for (std::size_t i = k; i < rows.size(); ++i) {
        if (!rows[i][k].is_zero()) { return i; }
    }
    return std::nullopt;
}

/// Returns the inverse by Gauss-Jordan elimination.
std::optional<NumberMatrix> by_elimination(const NumberMatrix& matrix) {
    const std::size_t s = matrix.size();
    NumberMatrix rows = matrix;  // [matrix | identity]
    for (std::size_t i = 0; i < s; ++i) {
        for (std::size_t j = 0; j < s; ++j) rows[i].push_back(Number(i == j ? 1 : 0));
    }
    for (std::size_t k = 0; k < s; ++k) {
        const auto pivot = pivot_row(rows, k);
        if (!pivot) return std::nullopt;
        std::swap(rows[*pivot], rows[k]);
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
        auto [adjugate, determinant] = by_minors(matrix);
        if (determinant.is_zero()) { return std::nullopt; }
        return ScaledInverse{std::move(adjugate), std::move(determinant)};
    }
    auto result = by_elimination(matrix);
    if (!result) { return std::nullopt; }
    return ScaledInverse{*std::move(result), Number(1)};
}

Number common_denominator(const NumberMatrix& rows) {
    Number result(1);
    for (const NumberVector& row : rows) {
        for (const Number& entry : row) {
            const Number rest = entry * result;
            const Element& element = *rest.value().element();
            if (element.is_zero()) { continue; }
            auto denominator = Element::quotient({{{}, element.denominator()}},
                                                 IntegerMultivariate(1), element.field());
            result = result * number(std::move(denominator), rest.value().field);
        }
    }
    return result;
}

std::optional<NumberVector> left_null_vector(const NumberMatrix& matrix) {
    // Row echelon form of [matrix | identity]: where a row vanishes on the left, the right shows
    // the combination of rows that it is.
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
