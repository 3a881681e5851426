// Decides whether an expression is zero for all values of its symbols.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/hamiltonian/algebra.hpp"
#include "generator/hamiltonian/zero.hpp"

namespace hvi::gen {

/// Whether an expression is zero for all values of its symbols. An enclosure of the value at a
/// point refutes it. GiNaC's normal form, in which functions are free symbols, or exact arithmetic
/// prove it.
[[nodiscard]] Vanishing vanishing(const Algebra& algebra, const GiNaC::ex& expression);

/// Whether an enclosure of the value at a point excludes zero.
[[nodiscard]] bool is_surely_not_zero(const Algebra& algebra, const GiNaC::ex& expression);

/// Whether an enclosure of the determinant at a point proves that a matrix is regular for almost
/// all values of the symbols. The matrix may be regular where this is false. NOTE: writing the
/// determinant out takes seconds from six rows on.
[[nodiscard]] bool is_surely_regular(const Algebra& algebra, const GiNaC::matrix& matrix);

}  // namespace hvi::gen
