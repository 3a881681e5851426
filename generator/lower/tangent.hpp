// Motion of a system together with that of a direction: its tangent map.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "generator/ir/system.hpp"

namespace hvi::gen {

/// Returns the system of K = H_q dq + H_p dp, whose coordinates are (q, dq), with the momenta (dp,
/// p): q and p move as under H, and dq and dp as a direction that the motion carries along. For an
/// L the function is L_q dq + L_v dv, with the velocities (v, dv): dp is its derivative by v, and p
/// its derivative by dv. A step of a symplectic partitioned Runge-Kutta method for K is the step
/// for H, and for directions exactly its derivative, since these methods commute with
/// differentiation. Directions begin at 0, and the energy is H. Where sums stay loops, K has sums
/// over the same loops. In scaled time a direction has a part along the time, and one along its
/// momentum. Precondition: there are no rotations.
[[nodiscard]] System with_tangent(System system);

/// Returns the system of K + dH/da for a parameter a. Its direction is the derivative of the motion
/// by a, and begins as the derivative of the initial values: in scaled time its part along the
/// momentum e begins as the derivative of -H. Precondition: as above, no initial value is
/// SystemStart::MinusEnergy, and a is a parameter of the system.
[[nodiscard]] System with_sensitivity(System system, const std::string& parameter);

}  // namespace hvi::gen
