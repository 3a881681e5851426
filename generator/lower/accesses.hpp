// Elements that values depend on.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/ir/system.hpp"

namespace hvi::gen {

/// Returns the accesses that the values depend on, ascending, by their numbers in the system.
[[nodiscard]] std::vector<std::size_t> accesses_in(const System& system,
                                                   const std::vector<Scaled>& values);

/// Returns the number of the access to an element of a family, a new one where there is none yet.
/// Its input has the name of the element, `x[i+1]`.
[[nodiscard]] std::size_t access_to(System& system, FamilyKind kind, std::size_t family,
                                    std::vector<ElementIndex> indices);

}  // namespace hvi::gen
