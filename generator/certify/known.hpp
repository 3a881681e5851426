// Names of a method and of its adjoint.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/exact/methods/tableau.hpp"

namespace hvi::gen {

/// Returns the named methods with this tableau, single methods first. Empty for coefficients that
/// are not those of a basis of polynomials at the roots of one over Q.
[[nodiscard]] std::vector<std::string> known_names(const Tableau& tableau);

/// Returns the names of the adjoint, the method whose step with h is the inverse of a step with -h.
/// The adjoint has the mirrored basis at the mirrored nodes: where A integrates phi_j from 0 to
/// c_i, the adjoint's integrates it from c_i to 1 (Hairer, Lubich & Wanner, Geometric Numerical
/// Integration, Theorem II.8.3: b_j - a_ij for the stages in reverse).
[[nodiscard]] std::vector<std::string> known_adjoints(const Tableau& tableau);

}  // namespace hvi::gen
