// Scenes and Hamiltonians as a user writes them, and what is found of them.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/symmetry/written_out.hpp"

namespace hvi::gen {

/// Finds symmetries of an H with coordinates and momenta between commas, or with q, p.
inline SceneSymmetries found_of(const std::string& hamiltonian, const std::string& coordinates = "",
                                const std::string& momenta = "") {
    WrittenOutScene scene;
    scene.mechanics = coordinates.empty()
                          ? hamiltonian_from_text(given("--hamiltonian", hamiltonian))
                          : hamiltonian_from_text(given("--hamiltonian", hamiltonian),
                                                  given("--coordinates", coordinates),
                                                  given("--momenta", momenta));
    return symmetries_of(scene);
}

inline SceneSymmetries found_of_scene(const std::string& toml) {
    return find_symmetries(scene_from_toml({"scene.toml", toml}));
}

inline std::vector<std::string> momentum_maps(const SceneSymmetries& found) {
    std::vector<std::string> texts;
    for (const AffineSymmetry& symmetry : found.affine.basis)
        texts.push_back(to_text(symmetry.momentum_map));
    return texts;
}

inline std::string algebra_name(const SceneSymmetries& found) {
    return found.affine.algebra ? found.affine.algebra->name : "?";
}

}  // namespace hvi::gen
