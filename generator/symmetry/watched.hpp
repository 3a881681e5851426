// A scene with its momentum maps among its invariants.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/symmetry/statements.hpp"

namespace hvi::gen {

/// What find_symmetries() finds with the work that a run has for it, which takes about a second.
/// Empty where that is not enough: `symmetry_work_is_spent` says so. Throws as it does.
[[nodiscard]] std::optional<SceneSymmetries> symmetries_within_a_second(const Scene& scene,
                                                                        const UnrollWish& wish);
constexpr const char* symmetry_work_is_spent = "the search was given up after about a second";

/// What is watched in runs of a scene.
struct Watched {
    std::optional<SceneSymmetries> found;
    std::string left_out;  ///< why nothing was looked for; empty where something was, or where of
                           ///< functions of the user's own nothing is known
    std::vector<std::string> names;  ///< the energy, where it is conserved, and invariants

    /// Of what is watched. Empty where nothing was found out.
    [[nodiscard]] std::vector<Statement> statements(const KeepingFacts& method) const;
};

/// Adds the momentum maps that are found to the scene's invariants: those that are no multiple of
/// one of these or of a single momentum, and at most 16; and those of [symmetries]. Nothing is
/// looked for where that would take long, or is seen to. Warns of an invariant that is not
/// conserved.
[[nodiscard]] Watched watch(Scene& scene, const UnrollWish& wish);

}  // namespace hvi::gen
