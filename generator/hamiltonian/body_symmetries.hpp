// Symmetries of rotating bodies.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/hamiltonian/affine_symmetries.hpp"
#include "generator/hamiltonian/conserved.hpp"

namespace hvi::gen {

/// Finds symmetries made of affine transformations q' = C q + d, of turns R' = hat(omega) R of
/// space, one for each rotation, and of turns R' = R hat(eta) of a body. The momentum map is
///
///     p (C q + d) + omega R L + eta L.
///
/// Values at rotations alone prove that these are all, as the entries of a rotation are no
/// independent functions. Throws as Algebra does. Precondition: there are rotations.
[[nodiscard]] AffineSymmetries body_symmetries(const Hamiltonian& hamiltonian);

/// Finds for each quantity I whether {I, H} vanishes, and whether I is a linear combination of
/// these momentum maps, and so a momentum map. Finds nothing else. Throws as findings() does.
[[nodiscard]] std::vector<QuantityFinding> body_findings(const Hamiltonian& hamiltonian,
                                                         const std::vector<Quantity>& quantities,
                                                         const std::vector<Expression>& maps);

}  // namespace hvi::gen
