// Which named methods a method is, and its adjoint.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/exact/methods/tableau.hpp"

namespace hvi::gen {

/// The named methods with the tableau of this one, those with a name of their own first. Empty for
/// coefficients that are not those of a basis of polynomials at the roots of one over Q.
[[nodiscard]] std::vector<std::string> known_names(const Tableau& tableau);

/// The same for the adjoint, the method whose step with h is the inverse of a step with -h. It is
/// the one of the mirrored basis at the mirrored nodes: where A integrates phi_j from 0 to c_i, the
/// adjoint's integrates it from c_i to 1 (Hairer, Lubich & Wanner, Geometric Numerical Integration,
/// Theorem II.8.3: b_j - a_ij for the stages in reverse).
[[nodiscard]] std::vector<std::string> known_adjoints(const Tableau& tableau);

}  // namespace hvi::gen
