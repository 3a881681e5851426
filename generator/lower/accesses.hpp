// Elements that values are made of.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/ir/system.hpp"

namespace hvi::gen {

/// The accesses that the values depend on, ascending, by their numbers in the system.
[[nodiscard]] std::vector<std::size_t> accesses_in(const System& system,
                                                   const std::vector<Scaled>& values);

}  // namespace hvi::gen
