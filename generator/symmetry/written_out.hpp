// Symmetries of scenes without indices.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/read/written_out_scene.hpp"
#include "generator/symmetry/symmetries.hpp"

namespace hvi::gen {

/// Gives a Hamiltonian or Lagrangian the values of all parameters of the scene.
template <class Mechanics>
[[nodiscard]] Mechanics with_values(Mechanics mechanics, const WrittenOutScene& scene) {
    mechanics.parameters.clear();
    for (const Parameter& parameter : scene.parameters)
        if (has_value(parameter)) mechanics.parameters.push_back(parameter);
    return mechanics;
}

/// Finds symmetries by exact algebra, for the values of the scene's parameters. Throws as
/// affine_symmetries() does; for more than most_degrees_of_symmetries degrees of freedom; and
/// InputError where the scene calls functions of the user's own, of which nothing is known.
[[nodiscard]] SceneSymmetries symmetries_of(const WrittenOutScene& scene);

}  // namespace hvi::gen
