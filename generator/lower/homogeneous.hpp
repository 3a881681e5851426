// Extension of H to one homogeneous of degree 2, whose motion tells the modified Hamiltonian of a
// method.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/ir/system.hpp"

namespace hvi::gen {

/// Returns the system of K = c^2 T(p/c) + a^2 U(q/a, p/a), where T has the terms of H of momenta
/// alone, and U all others. K is H made homogeneous (R. D. Skeel & D. J. Hardy, SIAM J. Sci.
/// Comput. 23, 2001, 1172-1188), each part with a variable of its own, so that K is separable where
/// H is. The coordinate a and the momentum c stay 1, as K does not depend on their partners b and
/// d, and q and p move as under H.
///
/// A symplectic partitioned Runge-Kutta method commutes with linear scalings. So its modified
/// Hamiltonian K~ is homogeneous of degree 2 as well. By Euler's theorem, at a = c = 1, the
/// modified Hamiltonian of H is
///
///     H~ = (p q' - q p' - b' + d')/2
///
/// on the curve (q, p, b, d) through the steps. b and d begin at 0, and may be set to 0 before any
/// step. The coordinates are (q, a, d) with the momenta (p, b, c); d and c are left out where T is
/// quadratic, since c^2 T(p/c) is T. The energy is H, and invariants are left out. Preconditions: H
/// is written out and does not depend on the time; no rotations, no scaled time.
[[nodiscard]] System with_homogeneous_extension(System system);

}  // namespace hvi::gen
