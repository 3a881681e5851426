// H as a sum of parts, for splittings.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/lower/split_choice.hpp"
#include "generator/options/wishes.hpp"
#include "generator/pipeline/lowered.hpp"

namespace hvi::gen {

/// Returns the parts that the scene names, or the ways that are found to take H apart; see
/// split_candidates(). Throws
/// InputError and MathError for an H without known parts, for parts that are not H, and as
/// check_splitting() does.
[[nodiscard]] std::vector<SplitCandidate> ways_to_split(const LoweredScene& scene,
                                                        const Method& method = {},
                                                        const StepperWishes& wishes = {});

/// Returns the system with the parts of the way that is chosen. Throws as ways_to_split() does.
[[nodiscard]] System in_parts(const LoweredScene& scene, const Method& method = {},
                              const StepperWishes& wishes = {});

/// Returns the system with its parts where the method is a splitting whose steps are to be flows of
/// these; nothing where steps are kicks and drifts of T(p) and U(q), as for other explicit methods:
/// see Scene::split. Throws as in_parts() does.
[[nodiscard]] std::optional<System> system_in_parts(const Method& method, const LoweredScene& scene,
                                                    const StepperWishes& wishes);

/// Returns the names of the scene's invariants that the flow of each part keeps, for all values of
/// parameters; none where steps are no flows of parts.
[[nodiscard]] std::vector<std::string> kept_by_flows(const System& system,
                                                     const LoweredScene& scene);

}  // namespace hvi::gen
