// Symmetries of rotating bodies.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/hamiltonian/affine_symmetries.hpp"
#include "generator/hamiltonian/conserved.hpp"

namespace hvi::gen {

/// Those that are made of affine transformations q' = C q + d, of rotations R' = hat(omega) R of
/// space, for each rotation one, and of rotations R' = R hat(eta) of a body. The momentum map is
///
///     p (C q + d) + omega R L + eta L.
///
/// That these are all is proved by values at rotations alone, as the
/// entries of a rotation are no independent functions. Throws what Algebra throws. Precondition:
/// there are rotations.
[[nodiscard]] AffineSymmetries body_symmetries(const Hamiltonian& hamiltonian);

/// Of each, whether {I, H} vanishes, and whether I is made of these momentum maps, linearly: then
/// it is one. Nothing else is looked at. Throws as findings() does.
[[nodiscard]] std::vector<QuantityFinding> body_findings(const Hamiltonian& hamiltonian,
                                                         const std::vector<Quantity>& quantities,
                                                         const std::vector<Expression>& maps);

}  // namespace hvi::gen
