// Initial values of the families of a system with loops.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/ir/system.hpp"
#include "generator/lower/declarations.hpp"

namespace hvi::gen {

/// Returns the initial values of coordinates, then of conjugates, which are families of the system.
/// Throws InputError for values that are missing, of another count or with other indices than their
/// family, or that depend on a variable, and for a value of a name that is no variable.
[[nodiscard]] std::vector<SystemStart> starts_of(System& system, const Declarations& names,
                                                 const Scene& scene);

}  // namespace hvi::gen
