// Matrices whose entries are near the diagonal in some order.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <complex>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include <hvi/detail/linear/sparse_matrix.hpp>

namespace hvi::detail {

/// An order of rows and columns that brings the entries of a matrix near the diagonal. The order of
/// a chain stays, and the two halves of a ring are laid side by side. Each row is followed by the
/// rows that it is coupled with, rows with few couplings first (Cuthill & McKee, Reducing the
/// bandwidth of sparse symmetric matrices, 1969). The first row is as far as possible from some
/// other.
class NarrowOrder {
public:
    NarrowOrder() = default;

    /// Precondition: the places of entries are symmetric.
    template <class Scalar>
    explicit NarrowOrder(const SparseMatrix<Scalar>& matrix)
        : place_(matrix.size(), unseen), seen_(matrix.size(), 0) {
        std::vector<std::size_t> rows(matrix.size());
        std::iota(rows.begin(), rows.end(), std::size_t{0});
        sort_by_degree(matrix, rows.begin(), rows.end());
        std::size_t next = 0;
        for (const std::size_t row : rows) {
            if (place_[row] != unseen) { continue; }
            for (const std::size_t i : around(matrix, around(matrix, row).back())) {
                place_[i] = next++;
            }
        }
        matrix.for_each([&](std::size_t i, std::size_t j, const Scalar&) {
            const std::size_t a = place_[i], b = place_[j];
            width_ = std::max(width_, a < b ? b - a : a - b);
        });
    }

    /// Returns the new place of row i.
    [[nodiscard]] std::size_t operator[](std::size_t i) const { return place_[i]; }
    [[nodiscard]] std::size_t size() const { return place_.size(); }
    /// Returns the largest distance of an entry from the diagonal.
    [[nodiscard]] std::size_t width() const { return width_; }

private:
    static constexpr std::size_t unseen = static_cast<std::size_t>(-1);

    /// Returns all rows that are coupled with `start` through others, the nearest first.
    template <class Scalar>
    [[nodiscard]] std::vector<std::size_t> around(const SparseMatrix<Scalar>& matrix,
                                                  std::size_t start) {
        ++round_;
        std::vector<std::size_t> rows{start};
        seen_[start] = round_;
        for (std::size_t k = 0; k < rows.size(); ++k) {
            const std::size_t i = rows[k];
            const auto known = static_cast<std::ptrdiff_t>(rows.size());
            for (const std::size_t* j = matrix.begin_of(i); j != matrix.end_of(i); ++j) {
                if (seen_[*j] == round_) { continue; }
                seen_[*j] = round_;
                rows.push_back(*j);
            }
            sort_by_degree(matrix, rows.begin() + known, rows.end());
        }
        return rows;
    }

    template <class Scalar, class Iterator>
    static void sort_by_degree(const SparseMatrix<Scalar>& matrix, Iterator begin, Iterator end) {
        const auto degree = [&](std::size_t i) { return matrix.end_of(i) - matrix.begin_of(i); };
        std::stable_sort(begin, end,
                         [&](std::size_t i, std::size_t j) { return degree(i) < degree(j); });
    }

    std::vector<std::size_t> place_;
    std::vector<std::size_t> seen_;  ///< round of the search in which each row was seen last
    std::size_t round_ = 0, width_ = 0;
};

/// Returns a b, without the care for infinities that operator* of complex numbers takes.
template <class Number>
[[nodiscard]] inline Number product(const Number& a, const Number& b) {
    return a * b;
}
template <class Scalar>
[[nodiscard]] inline std::complex<Scalar> product(const std::complex<Scalar>& a,
                                                  const std::complex<Scalar>& b) {
    return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

/// Factors L and U of 1 + factor * matrix, real or complex, with row exchanges within the band
/// (Golub & Van Loan, Matrix Computations, Section 4.3.3).
template <class Number>
class BandFactors {
public:
    using Order = NarrowOrder;

    /// Computes the factors. Returns false where the matrix is singular, or not finite. Allocates
    /// when its size changes.
    template <class Scalar>
    [[nodiscard]] bool compute(const SparseMatrix<Scalar>& matrix, const Number& factor,
                               const NarrowOrder& order) {
        n_ = order.size();
        w_ = order.width();
        entries_.assign(n_ * (3 * w_ + 1), Number(0));
        pivots_.resize(n_);
        sorted_.resize(n_);
        for (std::size_t k = 0; k < n_; ++k) { at(k, k) = Number(1); }
        matrix.for_each([&](std::size_t i, std::size_t j, const Scalar& value) {
            at(order[i], order[j]) += factor * value;
        });
        for (std::size_t k = 0; k < n_; ++k) {
            if (!eliminate(k)) { return false; }
        }
        return true;
    }

    /// Replaces the right side b by the solution. Precondition: the order is that of compute().
    void solve(Number* b, const NarrowOrder& order) {
        for (std::size_t i = 0; i < n_; ++i) { sorted_[order[i]] = b[i]; }
        Number* const x = sorted_.data();
        for (std::size_t k = 0; k < n_; ++k) {
            std::swap(x[k], x[pivots_[k]]);
            for (std::size_t i = k + 1; i < end(k + w_); ++i) { x[i] -= product(at(i, k), x[k]); }
        }
        for (std::size_t k = n_; k-- > 0;) {
            for (std::size_t j = k + 1; j < end(k + 2 * w_); ++j) {
                x[k] -= product(at(k, j), x[j]);
            }
            x[k] = product(at(k, k), x[k]);
        }
        for (std::size_t i = 0; i < n_; ++i) { b[i] = x[order[i]]; }
    }

private:
    /// Returns an entry. Row i holds the columns i - w to i + 2 w.
    [[nodiscard]] Number& at(std::size_t i, std::size_t j) {
        return entries_[i * (3 * w_ + 1) + (j + w_ - i)];
    }

    /// Returns the size of a number for the choice of a pivot: for a complex number |re| + |im|.
    template <class Real>
    [[nodiscard]] static Real size(const Real& x) {
        return abs(x);
    }
    template <class Real>
    [[nodiscard]] static Real size(const std::complex<Real>& x) {
        return abs(x.real()) + abs(x.imag());
    }

    /// Returns one more than the last row or column up to k that exists.
    [[nodiscard]] std::size_t end(std::size_t k) const { return std::min(k + 1, n_); }

    /// Eliminates column k below the diagonal, and replaces the pivot by its inverse.
    [[nodiscard]] bool eliminate(std::size_t k) {
        std::size_t row = k;
        for (std::size_t i = k + 1; i < end(k + w_); ++i) {
            if (size(at(i, k)) > size(at(row, k))) { row = i; }
        }
        pivots_[k] = row;
        // NOTE: the multipliers of the two rows before stay where they are, see solve().
        for (std::size_t j = k; row != k && j < end(k + 2 * w_); ++j) {
            std::swap(at(k, j), at(row, j));
        }
        const auto pivot = size(at(k, k));
        if (!(pivot > 0) || !detail::is_finite(pivot)) { return false; }
        at(k, k) = Number(1) / at(k, k);
        for (std::size_t i = k + 1; i < end(k + w_); ++i) {
            at(i, k) = product(at(i, k), at(k, k));
            for (std::size_t j = k + 1; j < end(k + 2 * w_); ++j) {
                at(i, j) -= product(at(i, k), at(k, j));
            }
        }
        return true;
    }

    std::size_t n_ = 0, w_ = 0;
    std::vector<Number> entries_, sorted_;
    std::vector<std::size_t> pivots_;
};

}  // namespace hvi::detail
