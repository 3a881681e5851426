// Poincare's transformation of time: steps that adapt and stay symplectic.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/read/written_out_scene.hpp"

namespace hvi::gen {

/// Returns the scene with steps of s in place of t, where the scene gives dt/ds = g. Time becomes
/// another coordinate, whose momentum e begins as -H, so that H + e stays 0 (H. Poincare; E.
/// Hairer, Appl. Numer. Math. 25, 1997, 219-227):
///
///     K = g (H + e), and with the logarithmic scale K = log(T + e) - log(-U)
///
/// for H = T(p) + U(q), which is separable again (M. Preto & S. Tremaine, AJ 118, 1999, 2532-2541).
/// A scene without a scale is returned unchanged. A scene with an L is transformed to its H first,
/// and keeps momenta: K is linear in e, so that dt/ds does not determine e, and K has no
/// Lagrangian.
///
/// Throws as with_hamiltonian() does; InputError, with the place of the scale, for rotations and
/// where H is not T(p) + U(q) and has to be; MathError where g is provably not positive at the
/// start.
[[nodiscard]] WrittenOutScene with_time_scale(WrittenOutScene scene);

}  // namespace hvi::gen
