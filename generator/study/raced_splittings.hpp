// Splittings that are worth measuring on a scene.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/pipeline/lowered.hpp"

namespace hvi::gen {

/// Returns the names of splittings whose steps of the scene are flows of parts of its H, with
/// compositions: `strang-kahan-li:8`. Those for a small second part are among them where the scene
/// names two parts. Empty where no flows are known, where splittings are refused, and where they
/// are kicks and drifts, as other explicit methods are.
[[nodiscard]] std::vector<const char*> raced_splittings(const LoweredScene& scene);

}  // namespace hvi::gen
