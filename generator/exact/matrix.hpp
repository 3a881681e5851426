// Vectors and matrices of exact numbers.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>

#include "generator/exact/tableau.hpp"

namespace hvi::gen {

[[nodiscard]] NumberVector operator*(const NumberMatrix& matrix, const NumberVector& vector);
[[nodiscard]] NumberMatrix operator*(const NumberMatrix& left, const NumberMatrix& right);
[[nodiscard]] NumberMatrix transpose(const NumberMatrix& matrix);

/// The inverse of a square matrix, by Gauss-Jordan elimination; empty when it is singular.
[[nodiscard]] std::optional<NumberMatrix> inverse(const NumberMatrix& matrix);

/// A vector v != 0 with v^T matrix = 0, or empty when the rows are independent. The last component
/// that is not zero is 1.
[[nodiscard]] std::optional<NumberVector> left_null_vector(const NumberMatrix& matrix);

}  // namespace hvi::gen
