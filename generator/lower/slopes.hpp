// Derivatives of values and of sums, by the variables in them.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/ir/system.hpp"

namespace hvi::gen {

/// The derivatives of a value by accesses, but those that are zero.
[[nodiscard]] std::vector<AccessSlope> slopes(System& system, const Scaled& value,
                                              const std::vector<std::size_t>& accesses);

/// The sum with the accesses in its value, and its derivatives by those that are variables: of
/// rotations by their turns, which are accesses already.
[[nodiscard]] SystemSum differentiated(System& system, SystemSum sum);

}  // namespace hvi::gen
