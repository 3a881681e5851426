// The state of a stepper with rotations.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "generator/ir/system.hpp"
#include "generator/read/written_out_scene.hpp"

namespace hvi::gen {

/// `struct Placement` with q and the rotations, and `struct Bodies`, which is one with p and the
/// angular momenta; and what makes of these a hvi::detail::ChartState, and back. Members are called
/// as the scene has them. Precondition: there are rotations.
[[nodiscard]] std::string bodies_text(const System& system);

/// Throws InputError where two members of these would have one name.
void check_rotation_names(const WrittenOutScene& scene);

}  // namespace hvi::gen
