// A matrix that an iteration multiplies with and divides by, computed once a step.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <hvi/detail/linear/dense.hpp>
#include <hvi/detail/numbers/scalar.hpp>
#include <hvi/detail/stages/system.hpp>

namespace hvi::detail {

/// A square matrix and its inverse. NOTE: good enough for what only says how an iteration gets to
/// its end, not where that is.
template <class Vector>
class FrozenMatrix {
public:
    /// `fill` sets the entries that are not zero. False where the matrix is singular or not finite.
    template <class Fill>
    [[nodiscard]] bool compute(std::size_t n, Fill fill) {
        if (matrix_.size() != n) {
            matrix_ = inverse_ = SquareMatrix<Scalar>(n);
            column_.resize(n);
        }
        matrix_.set_zero();
        fill(matrix_);
        if (!factors_.compute(matrix_)) { return false; }
        for (std::size_t j = 0; j < n; ++j) {
            for (std::size_t i = 0; i < n; ++i) { column_[i] = i == j ? 1 : 0; }
            factors_.solve(column_.data());
            for (std::size_t i = 0; i < n; ++i) { inverse_(i, j) = column_[i]; }
        }
        return inverse_.is_finite();
    }

    [[nodiscard]] bool is_finite() const { return matrix_.is_finite(); }

    [[nodiscard]] Vector times(const Vector& v) const { return product(matrix_, v); }
    [[nodiscard]] Vector inverse_times(const Vector& v) const { return product(inverse_, v); }

private:
    using Scalar = ScalarOf<Vector>;

    [[nodiscard]] static Vector product(const SquareMatrix<Scalar>& matrix, const Vector& v) {
        Vector result = v;
        for (std::size_t i = 0; i < matrix.size(); ++i) {
            Scalar sum = 0;
            for (std::size_t j = 0; j < matrix.size(); ++j) { sum += matrix(i, j) * at(v, j); }
            at(result, i) = sum;
        }
        return result;
    }

    SquareMatrix<Scalar> matrix_, inverse_;
    Factors<Scalar> factors_;
    std::vector<Scalar> column_;
};

}  // namespace hvi::detail
