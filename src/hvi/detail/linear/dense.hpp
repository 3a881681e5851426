// Small dense systems of linear equations.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include <hvi/detail/numbers/arithmetic.hpp>
#include <hvi/detail/numbers/scalar.hpp>

namespace hvi::detail {

/// A square matrix.
template <class Scalar>
class SquareMatrix {
public:
    SquareMatrix() = default;
    explicit SquareMatrix(std::size_t size) : size_(size), entries_(size * size) {}

    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] Scalar& operator()(std::size_t i, std::size_t j) {
        return entries_[i * size_ + j];
    }
    [[nodiscard]] Scalar operator()(std::size_t i, std::size_t j) const {
        return entries_[i * size_ + j];
    }

    [[nodiscard]] bool is_finite() const {
        for (const Scalar entry : entries_) {
            if (!detail::is_finite(entry)) { return false; }
        }
        return true;
    }

    /// Sets the size, and all entries to zero. Allocates when the size changes.
    void set_zero(std::size_t size) {
        size_ = size;
        entries_.assign(size * size, Scalar(0));
    }
    void set_zero() { entries_.assign(entries_.size(), Scalar(0)); }
    void set_identity() {
        set_zero();
        for (std::size_t i = 0; i < size_; ++i) { (*this)(i, i) = 1; }
    }

private:
    std::size_t size_ = 0;
    std::vector<Scalar> entries_;
};

/// Factors L and U of a matrix, with row exchanges.
///
/// NOTE: factors of Eigen have the same result, but take ten times as long to compile as the rest
/// of a scene's stepper, whose systems are small.
template <class Scalar>
class Factors {
public:
    /// Computes the factors. Returns false where the matrix is singular, or not finite. Allocates
    /// when its size changes.
    [[nodiscard]] bool compute(const SquareMatrix<Scalar>& matrix) {
        rows_ = matrix;
        pivots_.resize(matrix.size());
        for (std::size_t k = 0; k < matrix.size(); ++k) {
            pivots_[k] = largest(k);
            exchange(k, pivots_[k]);
            // NOTE: a NaN is not larger than 0, and infinity eliminates to one.
            if (!(abs(rows_(k, k)) > 0)) { return false; }
            for (std::size_t i = k + 1; i < matrix.size(); ++i) { eliminate(k, i); }
        }
        return true;
    }

    /// Replaces the right side b by the solution.
    void solve(Scalar* b) const { solve(b, rows_.size()); }
    /// Replaces the right side b by the solution, for a size n that the compiler knows.
    void solve(Scalar* b, std::size_t n) const {
        for (std::size_t k = 0; k < n; ++k) { std::swap(b[k], b[pivots_[k]]); }
        for (std::size_t k = 0; k < n; ++k) {
            for (std::size_t j = 0; j < k; ++j) { b[k] -= rows_(k, j) * b[j]; }
        }
        for (std::size_t k = n; k-- > 0;) {
            for (std::size_t j = k + 1; j < n; ++j) { b[k] -= rows_(k, j) * b[j]; }
            b[k] /= rows_(k, k);
        }
    }

private:
    [[nodiscard]] std::size_t largest(std::size_t k) const {
        std::size_t row = k;
        for (std::size_t i = k + 1; i < rows_.size(); ++i) {
            if (abs(rows_(i, k)) > abs(rows_(row, k))) { row = i; }
        }
        return row;
    }

    /// Exchanges two rows, with the factors of L to their left.
    void exchange(std::size_t k, std::size_t row) {
        if (row == k) { return; }
        for (std::size_t j = 0; j < rows_.size(); ++j) { std::swap(rows_(k, j), rows_(row, j)); }
    }

    void eliminate(std::size_t k, std::size_t i) {
        const Scalar factor = rows_(i, k) / rows_(k, k);
        rows_(i, k) = factor;
        for (std::size_t j = k + 1; j < rows_.size(); ++j) { rows_(i, j) -= factor * rows_(k, j); }
    }

    SquareMatrix<Scalar> rows_;  ///< U, and below its diagonal L without its unit diagonal
    std::vector<std::size_t> pivots_;
};

/// Matrices and factors for PairEquations.
template <class Scalar>
class DenseAlgebra {
public:
    using Index = std::size_t;

    SquareMatrix<Scalar> Hqq, Hqp, Hpp;

    void resize(std::size_t n, std::size_t unknowns) {
        for (SquareMatrix<Scalar>* block : {&Hqq, &Hqp, &Hpp}) { *block = SquareMatrix<Scalar>(n); }
        jacobian_ = SquareMatrix<Scalar>(unknowns);
    }

    void clear() {
        for (SquareMatrix<Scalar>* block : {&Hqq, &Hqp, &Hpp}) { block->set_zero(); }
    }

    void set_identity() { jacobian_.set_identity(); }
    [[nodiscard]] Scalar& jacobian(std::size_t i, std::size_t j) { return jacobian_(i, j); }
    [[nodiscard]] bool is_finite() const { return jacobian_.is_finite(); }
    [[nodiscard]] bool factorise() { return factors_.compute(jacobian_); }
    void solve(Scalar* b) const { factors_.solve(b); }

private:
    SquareMatrix<Scalar> jacobian_;
    Factors<Scalar> factors_;
};

}  // namespace hvi::detail
