// Affine vector fields C q + d as vectors of n^2 + n numbers.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "generator/hamiltonian/sparse_equations.hpp"

namespace hvi::gen {

/// The order of the unknowns: d first, then the entries of C above its diagonal, on it, and below
/// it. Later unknowns stay free in the solutions of equations. So translations have no C, and
/// rotations are about the origin where they can be, and turn x to y, not y to x.
class AffineUnknowns {
public:
    explicit AffineUnknowns(std::size_t n);

    [[nodiscard]] std::size_t dimension() const { return n_; }
    [[nodiscard]] std::size_t count() const { return n_ + entries_.size(); }
    /// Returns row and column in C. Precondition: number >= dimension().
    [[nodiscard]] std::pair<std::size_t, std::size_t> entry(std::size_t number) const {
        return entries_[number - n_];
    }
    [[nodiscard]] std::size_t number(std::size_t row, std::size_t column) const {
        return numbers_[row * n_ + column];
    }

private:
    std::size_t n_;
    std::vector<std::pair<std::size_t, std::size_t>> entries_;
    std::vector<std::size_t> numbers_;
};

/// Multiplies a field so that its entries are whole numbers or polynomials without a common factor.
/// The last entry becomes positive, or gets the sign with which one would write it. NOTE: entries
/// that are other functions stay fractions.
[[nodiscard]] SparseVector without_denominators(const Algebra& algebra, const SparseVector& field);

[[nodiscard]] bool is_translation(const AffineUnknowns& unknowns, const SparseVector& field);

/// Returns the bracket of two fields p (C q + d): C1 C2 - C2 C1, and C1 d2 - C2 d1.
[[nodiscard]] SparseVector poisson_bracket(const AffineUnknowns& unknowns, const SparseVector& a,
                                           const SparseVector& b);

/// Whether C^3 = -c C with c > 0, and d is C times a vector where it is not 0: then the flow is
/// periodic. Decides it for entries that are numbers only.
[[nodiscard]] bool is_rotation(const AffineUnknowns& unknowns, const SparseVector& field);

}  // namespace hvi::gen
