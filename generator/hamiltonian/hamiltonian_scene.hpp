// A scene with a Lagrangian, by its Hamiltonian.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/read/written_out_scene.hpp"

namespace hvi::gen {

/// The scene with H = p v - L in place of L: it begins with p = dL/dv, and where invariants, events
/// or the scale of the time have velocities, v = dH/dp stands. A scene with an H stays what it is.
/// Throws MathError as legendre_transform() does, and InputError for an event that sets something,
/// which would be velocities.
[[nodiscard]] WrittenOutScene with_hamiltonian(WrittenOutScene scene);

}  // namespace hvi::gen
