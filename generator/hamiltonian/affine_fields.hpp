// Affine vector fields C q + d as vectors of n^2 + n numbers.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "generator/hamiltonian/sparse_equations.hpp"

namespace hvi::gen {

/// Which number stands where: d first, then C above its diagonal, on it, and below. What stands
/// behind is free in the solutions of equations: translations have no C, rotations are about the
/// origin where they can be, and turn x to y, not y to x.
class AffineUnknowns {
public:
    explicit AffineUnknowns(std::size_t n);

    [[nodiscard]] std::size_t dimension() const { return n_; }
    [[nodiscard]] std::size_t count() const { return n_ + entries_.size(); }
    /// Row and column of C. Precondition: number >= dimension().
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

/// Whole numbers or polynomials without a common factor, the last of them positive, or as one would
/// write it. NOTE: where they are other functions they stay fractions.
[[nodiscard]] SparseVector without_denominators(const Algebra& algebra, const SparseVector& field);

[[nodiscard]] bool is_translation(const AffineUnknowns& unknowns, const SparseVector& field);

/// Of p (C q + d): C1 C2 - C2 C1, and C1 d2 - C2 d1.
[[nodiscard]] SparseVector poisson_bracket(const AffineUnknowns& unknowns, const SparseVector& a,
                                           const SparseVector& b);

/// Whether C^3 = -c C with c > 0, and d is C times a vector where it is not 0: then the flow is
/// periodic. Of numbers alone.
[[nodiscard]] bool is_rotation(const AffineUnknowns& unknowns, const SparseVector& field);

}  // namespace hvi::gen
