// The user's own functions in dual numbers.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/read/scene.hpp"

namespace hvi::gen {

/// Returns the scene with functions that take dual numbers in place of its own. They are made of
/// the derivatives that the user's headers define.
[[nodiscard]] Scene with_dual_functions(Scene scene);

}  // namespace hvi::gen
