// Replaces the Lagrangian of a scene by its Hamiltonian.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/read/written_out_scene.hpp"

namespace hvi::gen {

/// Returns the scene with H = p v - L in place of L. It begins with p = dL/dv, and v = dH/dp
/// replaces velocities in invariants, events and the scale of time. A scene with an H is returned
/// unchanged. Throws MathError as legendre_transform() does, and InputError for an event that sets
/// something, which would be velocities.
[[nodiscard]] WrittenOutScene with_hamiltonian(WrittenOutScene scene);

}  // namespace hvi::gen
