// Whether an expression is zero for all values of its symbols.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/hamiltonian/algebra.hpp"
#include "generator/hamiltonian/zero.hpp"

namespace hvi::gen {

/// Refuted by an enclosure of the value at a point; proved by GiNaC's normal form, in which
/// functions are free symbols, or in exact arithmetic.
[[nodiscard]] Vanishing vanishing(const Algebra& algebra, const GiNaC::ex& expression);

/// Whether an enclosure of the value at a point excludes zero.
[[nodiscard]] bool is_surely_not_zero(const Algebra& algebra, const GiNaC::ex& expression);

/// Whether an enclosure of its determinant at a point proves that a matrix is regular for almost
/// all values of the symbols. Where it does not, the matrix may be so all the same. NOTE: to write
/// out the determinant takes seconds from six rows on.
[[nodiscard]] bool is_surely_regular(const Algebra& algebra, const GiNaC::matrix& matrix);

}  // namespace hvi::gen
