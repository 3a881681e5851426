// A scene with its momentum maps among its invariants.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/read/indexed_scene.hpp"
#include "generator/symmetry/statements.hpp"

namespace hvi::gen {

/// What is watched in runs of a scene.
struct Watched {
    std::optional<SceneSymmetries> found;
    std::string left_out;            ///< why nothing was found out; empty where something was
    bool takes_long = false;         ///< and so nothing was looked for
    std::vector<std::string> names;  ///< the energy, where it is conserved, and invariants

    /// Of what is watched. Empty where nothing was found out.
    [[nodiscard]] std::vector<Statement> statements(const KeepingFacts& method) const;
};

/// Adds the momentum maps that are found to the scene's invariants: those that are no multiple of
/// one of these or of a single momentum, and at most 16; and those of [symmetries]. Nothing is
/// looked for where that would take long. Warns of an invariant that is not conserved.
[[nodiscard]] Watched watch(Scene& scene);

/// The same of a scene of any size: what is one sum.
[[nodiscard]] Watched watch(IndexedScene& scene);

}  // namespace hvi::gen
