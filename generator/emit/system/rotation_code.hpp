// The state of a stepper with rotations.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "generator/ir/system.hpp"
#include "generator/read/written_out_scene.hpp"

namespace hvi::gen {

/// Returns `struct Placement` with q and the rotations, `struct Bodies`, a Placement with p and the
/// angular momenta, and conversions between Bodies and a hvi::detail::ChartState. Members have the
/// names of the scene. Precondition: there are rotations.
[[nodiscard]] std::string bodies_text(const System& system);

/// Throws InputError where two members would have one name.
void check_rotation_names(const WrittenOutScene& scene);

}  // namespace hvi::gen
