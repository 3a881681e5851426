// Elements that values are made of.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/ir/system.hpp"

namespace hvi::gen {

/// The accesses that the values depend on, ascending, by their numbers in the system.
[[nodiscard]] std::vector<std::size_t> accesses_in(const System& system,
                                                   const std::vector<Scaled>& values);

/// The number of the access to an element of a family, a new one where there is none yet. Its input
/// is called as the element is, `x[i+1]`.
[[nodiscard]] std::size_t access_to(System& system, FamilyKind kind, std::size_t family,
                                    std::vector<ElementIndex> indices);

}  // namespace hvi::gen
