// Where the families of a system with loops begin.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/ir/system.hpp"
#include "generator/lower/declarations.hpp"

namespace hvi::gen {

/// The starts of coordinates, then of conjugates, which are families of the system. Throws
/// InputError for one that is missing, has another count of values or of indices than its family,
/// or depends on a variable, and for a value of what is no variable.
[[nodiscard]] std::vector<SystemStart> starts_of(System& system, const Declarations& names,
                                                 const Scene& scene);

}  // namespace hvi::gen
