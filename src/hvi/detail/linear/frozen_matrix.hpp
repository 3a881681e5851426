// A matrix that an iteration multiplies with and divides by, computed once a step.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <hvi/detail/linear/dense.hpp>
#include <hvi/detail/numbers/arithmetic.hpp>
#include <hvi/detail/numbers/scalar.hpp>
#include <hvi/detail/stages/system.hpp>

namespace hvi::detail {

/// A square matrix, its inverse and its factors. NOTE: products with the inverse are good enough
/// for values that affect only the way of an iteration, not its end. Results are solved for with
/// the factors, whose residual is at rounding level however nearly singular the matrix is.
/// Precondition: vectors are of fixed size.
template <class Vector>
class FrozenMatrix {
public:
    /// Computes inverse and factors; `fill` sets the entries that are not zero. Returns false where
    /// the matrix is singular or not finite.
    template <class Fill>
    [[nodiscard]] bool compute(Fill fill) {
        computed_.set_zero();
        fill(computed_);
        if (!factors_.compute(computed_)) { return false; }
        bool is_finite = true;
        for (std::size_t j = 0; j < n; ++j) {
            Scalar column[n] = {};
            column[j] = 1;
            factors_.solve(column, n);
            for (std::size_t i = 0; i < n; ++i) {
                matrix_[i][j] = computed_(i, j);
                inverse_[i][j] = column[i];
                is_finite = is_finite && detail::is_finite(column[i]);
            }
        }
        return is_finite;
    }

    [[nodiscard]] bool is_finite() const { return computed_.is_finite(); }

    [[nodiscard]] Vector times(const Vector& v) const { return product(matrix_, v); }
    [[nodiscard]] Vector inverse_times(const Vector& v) const { return product(inverse_, v); }

    /// Returns the inverse times v, by the factors.
    [[nodiscard]] Vector solve(const Vector& v) const {
        Scalar values[n];
        for (std::size_t i = 0; i < n; ++i) { values[i] = at(v, i); }
        factors_.solve(values, n);
        Vector result = v;
        for (std::size_t i = 0; i < n; ++i) { at(result, i) = values[i]; }
        return result;
    }

private:
    using Scalar = ScalarOf<Vector>;
    static constexpr std::size_t n = fixed_size<Vector>();

    [[nodiscard]] static Vector product(const Scalar (&matrix)[n][n], const Vector& v) {
        Vector result = v;
        for (std::size_t i = 0; i < n; ++i) {
            Scalar sum = 0;
            for (std::size_t j = 0; j < n; ++j) { sum += matrix[i][j] * at(v, j); }
            at(result, i) = sum;
        }
        return result;
    }

    SquareMatrix<Scalar> computed_ = SquareMatrix<Scalar>(n);
    Factors<Scalar> factors_;
    Scalar matrix_[n][n] = {}, inverse_[n][n] = {};
};

}  // namespace hvi::detail
