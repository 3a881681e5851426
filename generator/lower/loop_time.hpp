// Poincare's transformation of time where sums stay loops.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/lower/declarations.hpp"
#include "generator/read/scene.hpp"

namespace hvi::gen {

/// Adds the time and its momentum e, as families without indices behind all others, and their
/// initial values: 0 for the time, and -H for e. From then on `t` is a coordinate. Throws NoLoops
/// for a Lagrangian, InputError for rotations. Precondition: the scene has a scale of the time.
void declare_scaled_time(System& system, Declarations& names, const Scene& scene);

/// Puts K of with_time_scale() in place of H, whose sums become totals of it; the energy is H.
/// Throws NoLoops where dt/ds is the arclength, or a distance between coordinates that are not seen
/// to be bodies, and where H has to be T(p) + U(q) and is not. Precondition: the time is declared,
/// and H is lowered.
[[nodiscard]] System with_scaled_time(System system, const Declarations& names, const Scene& scene);

}  // namespace hvi::gen
