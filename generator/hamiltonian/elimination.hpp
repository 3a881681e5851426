// Rank and inverse of a matrix of functions.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>

#include "generator/hamiltonian/algebra.hpp"

namespace hvi::gen {

/// The result of Gauss-Jordan elimination for symbols in general position.
struct Elimination {
    std::size_t rank = 0;
    std::optional<GiNaC::matrix> inverse;  ///< where the rank is full; each entry one fraction
};

/// Eliminates. Each pivot is proved not to vanish, and each entry that is taken for zero is proved
/// to vanish. Throws MathError, with the place of the function whose derivatives form the matrix,
/// where neither is proved. Precondition: a square matrix.
[[nodiscard]] Elimination eliminate(const Algebra& algebra, const GiNaC::matrix& matrix);

}  // namespace hvi::gen
