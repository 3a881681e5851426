// Derivatives of values and of sums, by the variables in them.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "generator/ir/system.hpp"

namespace hvi::gen {

/// Returns the derivatives of a value by accesses, except zeros.
[[nodiscard]] std::vector<AccessSlope> slopes(System& system, const Scaled& value,
                                              const std::vector<std::size_t>& accesses);

/// Returns the accesses that slopes are by.
[[nodiscard]] std::vector<std::size_t> accesses_of(const std::vector<AccessSlope>& slopes);

/// Returns the coefficients of a value that is a linear form in these variables, with constant
/// coefficients; empty where that is not seen by its derivatives, and its value where all variables
/// are 0.
[[nodiscard]] std::optional<std::vector<AccessSlope>>
linear_form(System& system, const Scaled& value, const std::vector<std::size_t>& variables);

/// Returns the sum with the accesses in its value, and its derivatives by those that are variables;
/// for rotations by their turns, which are accesses already.
[[nodiscard]] SystemSum differentiated(System& system, SystemSum sum);

/// Returns the system with the derivatives of its function and totals, and the accesses of all its
/// values, computed anew. A pass that has made another function needs this.
[[nodiscard]] System differentiated(System system);

}  // namespace hvi::gen
