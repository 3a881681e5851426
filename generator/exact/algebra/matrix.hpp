// Vectors and matrices of exact numbers.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>

#include "generator/exact/algebra/number_vector.hpp"

namespace hvi::gen {

[[nodiscard]] NumberVector operator*(const NumberMatrix& matrix, const NumberVector& vector);
[[nodiscard]] NumberVector operator*(const NumberVector& vector, const Number& factor);
[[nodiscard]] NumberMatrix operator*(const NumberMatrix& left, const NumberMatrix& right);
[[nodiscard]] NumberMatrix operator*(const NumberMatrix& matrix, const Number& factor);
[[nodiscard]] NumberMatrix operator+(const NumberMatrix& left, const NumberMatrix& right);
[[nodiscard]] NumberMatrix transpose(const NumberMatrix& matrix);
[[nodiscard]] NumberMatrix identity(std::size_t size);
[[nodiscard]] NumberMatrix zeros(std::size_t height, std::size_t width);
[[nodiscard]] bool is_zero(const NumberMatrix& matrix);
[[nodiscard]] bool is_table(const NumberMatrix& matrix, std::size_t height, std::size_t width);

/// Returns rows first .. last - 1.
[[nodiscard]] NumberMatrix rows(const NumberMatrix& matrix, std::size_t first, std::size_t last);
[[nodiscard]] NumberMatrix stacked(NumberMatrix upper, const NumberMatrix& lower);
[[nodiscard]] NumberMatrix beside(NumberMatrix left, const NumberMatrix& right);

/// Returns Kronecker's product, with blocks left_ij * right.
[[nodiscard]] NumberMatrix kronecker(const NumberMatrix& left, const NumberMatrix& right);

/// Return the numbers by their enclosures alone; 0 and 1 keep their exact meaning. Precondition: no
/// free parameter.
[[nodiscard]] Number without_closed_form(const Number& number);
[[nodiscard]] NumberVector without_closed_form(const NumberVector& numbers);
[[nodiscard]] NumberMatrix without_closed_form(const NumberMatrix& rows);

/// A matrix and a number to divide it by: sums of products are taken before the division, which is
/// what costs in a field with generators.
struct ScaledInverse {
    NumberMatrix adjugate;
    Number determinant;
};

/// Returns the inverse of a square matrix; empty when it is singular.
[[nodiscard]] std::optional<ScaledInverse> inverse(const NumberMatrix& matrix);

/// Returns a number, not zero, whose products with the entries have no denominators. Precondition:
/// the entries are exact.
[[nodiscard]] Number common_denominator(const NumberMatrix& rows);

/// Returns a vector v != 0 with v^T matrix = 0; empty when the rows are independent. The last
/// component that is not zero is 1.
[[nodiscard]] std::optional<NumberVector> left_null_vector(const NumberMatrix& matrix);

}  // namespace hvi::gen
