// Functions of the user's own in dual numbers.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/read/scene.hpp"

namespace hvi::gen {

/// The scene with functions that take dual numbers in place of its own: made of the derivatives
/// that the user's headers define.
[[nodiscard]] Scene with_dual_functions(Scene scene);

}  // namespace hvi::gen
