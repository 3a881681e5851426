// A scene with its momentum maps among its invariants.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/symmetry/statements.hpp"

namespace hvi::gen {

/// What is watched in runs of a scene.
struct WatchedScene {
    Scene scene;
    std::optional<SceneSymmetries> found;
    std::string left_out;  ///< why nothing was looked for; empty where something was

    /// Of what the scene's invariants are now, and of the energy. Empty where nothing was found
    /// out.
    [[nodiscard]] std::vector<Statement> statements(const KeepingFacts& method) const;
};

/// Adds the momentum maps that are found to the scene's invariants: those that are no multiple of
/// one of these or of a single momentum, and at most 16. Nothing is looked for where that would
/// take long. Warns of an invariant that is not conserved.
[[nodiscard]] WatchedScene watched(const Scene& scene);

}  // namespace hvi::gen
