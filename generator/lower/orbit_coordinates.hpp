// H of bodies that attract each other, as a sum of parts in coordinates of Jacobi or Poincare.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/ir/system.hpp"
#include "generator/read/scene.hpp"

namespace hvi::gen {

/// Returns the system with parts whose main one is Kepler orbits (Wisdom & Holman 1991):
///
/// - Jacobi: each body moves about the centre of mass Q_j of those before it, attracted by k_j, the
///   sum of its attractions to them. H = A + B, A = T(p) - sum_j k_j/|Q_j|.
/// - Democratic heliocentric (Duncan, Levison & Lee 1998): each body moves about the first one. H =
///   A + C + B, where C = |sum_(i>0) P_i|^2/(2 m_0) moves all by the motion of the first one.
///
/// B is the rest of the potential, also what is no attraction. Steps keep the coordinates of the
/// scene: vectors Q_j and their momenta are linear in these, and a flow computes changes alone.
/// Throws MathError at `place`, that of H, for an H that is not p^T K p/2 + U(q) with a mass for
/// each body, or without attractions -k/r. Precondition: as for with_parts().
[[nodiscard]] System with_orbits(System system, SplitChoice coordinates, const Place& place);

}  // namespace hvi::gen
