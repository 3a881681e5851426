// Matrices of rationals.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <flint/fmpq_mat.h>

#include <cstddef>
#include <optional>
#include <vector>

#include "generator/exact/algebra/number_vector.hpp"
#include "generator/exact/algebra/polynomial.hpp"

namespace hvi::gen {

/// A matrix of FLINT's rationals, freed by the destructor.
class RationalMatrix {
public:
    RationalMatrix(std::size_t rows, std::size_t columns) {
        fmpq_mat_init(matrix_, static_cast<slong>(rows), static_cast<slong>(columns));
    }
    RationalMatrix(const RationalMatrix&) = delete;
    RationalMatrix(RationalMatrix&& other) noexcept : RationalMatrix(0, 0) {
        fmpq_mat_swap(matrix_, other.matrix_);
    }
    RationalMatrix& operator=(const RationalMatrix&) = delete;
    ~RationalMatrix() { fmpq_mat_clear(matrix_); }
    [[nodiscard]] fmpq_mat_struct* get() { return matrix_; }
    [[nodiscard]] const fmpq_mat_struct* get() const { return matrix_; }
    [[nodiscard]] fmpq* entry(std::size_t row, std::size_t column) {
        return fmpq_mat_entry(matrix_, static_cast<slong>(row), static_cast<slong>(column));
    }

private:
    fmpq_mat_t matrix_;
};

[[nodiscard]] RationalMatrix operator*(const RationalMatrix& left, const RationalMatrix& right);
[[nodiscard]] RationalMatrix operator-(const RationalMatrix& left, const RationalMatrix& right);
[[nodiscard]] bool operator==(const RationalMatrix& left, const RationalMatrix& right);
[[nodiscard]] RationalMatrix transpose(const RationalMatrix& matrix);

/// Returns the coefficients of 1, x .. x^(width-1), a row for each polynomial. Precondition: their
/// degrees are below the width.
[[nodiscard]] RationalMatrix coefficient_rows(const std::vector<RationalPolynomial>& polynomials,
                                              std::size_t width);
/// Returns the polynomial of a single row.
[[nodiscard]] RationalPolynomial polynomial(const RationalMatrix& row);

/// Returns the rows of numbers as a matrix, if all of them are rational. Precondition: there is a
/// row.
[[nodiscard]] std::optional<RationalMatrix> rational_matrix(const NumberMatrix& rows);

/// Returns det(X + t Y) for square matrices, as a polynomial in t.
[[nodiscard]] RationalPolynomial determinant_of_pencil(const RationalMatrix& X,
                                                       const RationalMatrix& Y);

}  // namespace hvi::gen
