// Derivatives of values and of sums, by the variables in them.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "generator/ir/system.hpp"

namespace hvi::gen {

/// The derivatives of a value by accesses, but those that are zero.
[[nodiscard]] std::vector<AccessSlope> slopes(System& system, const Scaled& value,
                                              const std::vector<std::size_t>& accesses);

/// The accesses that slopes are by.
[[nodiscard]] std::vector<std::size_t> accesses_of(const std::vector<AccessSlope>& slopes);

/// The coefficients of a value that is a linear form in these variables, which no motion changes;
/// nothing where that is not seen: by its derivatives, and its value where all of them are 0.
[[nodiscard]] std::optional<std::vector<AccessSlope>>
linear_form(System& system, const Scaled& value, const std::vector<std::size_t>& variables);

/// The sum with the accesses in its value, and its derivatives by those that are variables: of
/// rotations by their turns, which are accesses already.
[[nodiscard]] SystemSum differentiated(System& system, SystemSum sum);

/// The system with the derivatives of its function and totals, and the accesses of all its values,
/// anew: what another function needs that a pass has made of it.
[[nodiscard]] System differentiated(System system);

}  // namespace hvi::gen
