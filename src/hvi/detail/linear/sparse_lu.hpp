// The factors of sparse matrices, by Eigen.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

// NOTE: where the compiler's options name no directory of Eigen, the usual one of systems is taken.
#if __has_include(<Eigen/SparseLU>)
#include <Eigen/SparseCore>
#include <Eigen/SparseLU>
#else
#include <eigen3/Eigen/SparseCore>
#include <eigen3/Eigen/SparseLU>
#endif

#include <hvi/detail/linear/sparse_matrix.hpp>

namespace hvi::detail {

/// An empty order: Eigen finds an order for each matrix that has few entries in its factors.
class OrderOfEigen {
public:
    OrderOfEigen() = default;
    template <class Scalar>
    explicit OrderOfEigen(const SparseMatrix<Scalar>&) {}
};

/// Factors L and U of 1 + factor * matrix, real or complex, with row exchanges. The pattern of
/// entries is analysed once for each size.
template <class Number>
class SparseLuFactors {
public:
    using Order = OrderOfEigen;

    SparseLuFactors() = default;
    ~SparseLuFactors() = default;
    /// NOTE: factors of Eigen cannot be copied; factors of the same matrix have the same bits.
    SparseLuFactors(const SparseLuFactors& other) { *this = other; }
    SparseLuFactors& operator=(const SparseLuFactors& other) {
        matrix_ = other.matrix_;
        if (matrix_.rows() > 0) { factors_.compute(matrix_); }
        return *this;
    }

    /// Computes the factors. Returns false where the matrix is singular, or not finite.
    template <class Scalar>
    [[nodiscard]] bool compute(const SparseMatrix<Scalar>& matrix, const Number& factor,
                               const OrderOfEigen&) {
        if (!matrix.is_finite()) { return false; }
        const auto n = static_cast<Index>(matrix.size());
        std::vector<Eigen::Triplet<Number, Index>> entries;
        for (Index k = 0; k < n; ++k) { entries.emplace_back(k, k, Number(1)); }
        matrix.for_each([&](std::size_t i, std::size_t j, const Scalar& value) {
            entries.emplace_back(static_cast<Index>(i), static_cast<Index>(j), factor * value);
        });
        const bool is_known = matrix_.rows() == n;
        matrix_.resize(n, n);
        matrix_.setFromTriplets(entries.begin(), entries.end());
        if (!is_known) { factors_.analyzePattern(matrix_); }
        factors_.factorize(matrix_);
        return factors_.info() == Eigen::Success;
    }

    /// Replaces the right side b by the solution.
    void solve(Number* b, const OrderOfEigen&) {
        Eigen::Map<Eigen::Matrix<Number, Eigen::Dynamic, 1>> x(b, matrix_.rows());
        x = factors_.solve(x).eval();
    }

private:
    using Index = int;

    Eigen::SparseMatrix<Number> matrix_;
    Eigen::SparseLU<Eigen::SparseMatrix<Number>, Eigen::COLAMDOrdering<Index>> factors_;
};

}  // namespace hvi::detail
