// Functions of the user's own in dual numbers.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/read/written_out_scene.hpp"

namespace hvi::gen {

/// The scene with functions that take dual numbers in place of its own: made of the derivatives
/// that the user's headers define.
[[nodiscard]] WrittenOutScene with_dual_functions(WrittenOutScene scene);

}  // namespace hvi::gen
