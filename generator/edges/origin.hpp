// What the motion of a scene is at q = p = 0.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/read/scene.hpp"

namespace hvi::gen {

enum class Origin {
    rest,      ///< dH/dq and dH/dp are zero
    singular,  ///< one of them is no number: a collision; or a matrix of zeros is no rotation
    other,     ///< neither, or it is not known
};

/// By the exact derivatives of H, in enclosures; of an H that depends on time, at t = 0; not known
/// where the scene has a Lagrangian or functions of the user's own. Throws as gradient() and
/// parameter_values() do.
[[nodiscard]] Origin origin_of(const Scene& scene);

}  // namespace hvi::gen
