// Adds the momentum maps of a scene to its invariants.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/symmetry/statements.hpp"

namespace hvi::gen {

/// Returns the result of find_symmetries() within the work that a run has for it, which takes about
/// a second. Returns nothing where that is not enough; `symmetry_work_is_spent` is its message.
/// Throws as find_symmetries() does.
[[nodiscard]] std::optional<SceneSymmetries> symmetries_within_a_second(const Scene& scene,
                                                                        const UnrollWish& wish);
constexpr const char* symmetry_work_is_spent = "the search was given up after about a second";

/// The quantities that are watched in runs of a scene.
struct Watched {
    std::optional<SceneSymmetries> found;
    std::string left_out;            ///< why nothing was sought, or empty
    std::vector<std::string> names;  ///< the energy, where it is conserved, and invariants

    /// Returns statements on the watched quantities. Empty where nothing was found.
    [[nodiscard]] std::vector<Statement> statements(const KeepingFacts& method) const;
};

/// Adds found momentum maps to the scene's invariants: at most 16 that are no multiples of an
/// invariant or of a single momentum, and those of [symmetries]. Does not search where that would
/// take long. Warns of an invariant that is not conserved.
[[nodiscard]] Watched watch(Scene& scene, const UnrollWish& wish);

}  // namespace hvi::gen
