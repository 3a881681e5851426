// Sums that stay loops, from an expression to a system.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/ir/system.hpp"
#include "generator/lower/declarations.hpp"

namespace hvi::gen {

/// Returns an expression as sums, with their derivatives: one for all summands that have equal
/// loops and depend on equal kinds of variables. Sums inside products and functions become totals
/// of the system. `known` are the values of symbols. Precondition: Declarations::meant(). Throws as
/// loop_terms() and value_of_term() do.
[[nodiscard]] std::vector<SystemSum> sums_of(System& system, const Declarations& names,
                                             const IndexedExpression& expression, Symbols known);

/// Returns the sums of H or L, which may depend on the time.
[[nodiscard]] std::vector<SystemSum> sums_in_time(System& system, const Declarations& names,
                                                  const IndexedExpression& function);

}  // namespace hvi::gen
