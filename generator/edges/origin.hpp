// The motion of a scene at q = p = 0.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/read/scene.hpp"

namespace hvi::gen {

enum class Origin {
    rest,      ///< dH/dq and dH/dp are zero
    singular,  ///< one of them is no number: a collision; or a matrix of zeros is no rotation
    other,     ///< neither of these, or not known
};

/// Decides by the exact derivatives of H, in enclosures. An H that depends on time is taken at t =
/// 0. Scenes with a Lagrangian or with functions of the user's own are not decided. Throws as
/// gradient() and parameter_values() do.
[[nodiscard]] Origin origin_of(const Scene& scene);

}  // namespace hvi::gen
