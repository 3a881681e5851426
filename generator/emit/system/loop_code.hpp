// The parts of a header that a scene with loops decides: H and its derivatives for any sizes.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "generator/emit/system/scene_code.hpp"

namespace hvi::gen {

/// Whether something is scattered: added where it belongs, one summand after the other.
[[nodiscard]] bool scatters(const System& system, const Step& step);

/// `struct System`: what a stepper needs of H, with loops where the scene has sums.
[[nodiscard]] std::string loop_system_text(const System& system, const SceneWishes& wishes,
                                           const Step& step);

}  // namespace hvi::gen
