// Rank and inverse of a matrix of functions.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>

#include "generator/hamiltonian/algebra.hpp"

namespace hvi::gen {

/// What Gauss and Jordan's elimination finds where the symbols are in general position.
struct Elimination {
    std::size_t rank = 0;
    std::optional<GiNaC::matrix> inverse;  ///< where the rank is full; each entry one fraction
};

/// Each pivot is proved not to vanish, and what is taken for zero to vanish. Throws MathError, with
/// the place of the function that the matrix is of, where neither is known. Precondition: a square
/// matrix.
[[nodiscard]] Elimination eliminate(const Algebra& algebra, const GiNaC::matrix& matrix);

}  // namespace hvi::gen
