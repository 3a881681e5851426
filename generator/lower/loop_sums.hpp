// Sums that stay loops, from an expression to a system.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/ir/system.hpp"
#include "generator/lower/declarations.hpp"

namespace hvi::gen {

/// The sums that an expression is, with their derivatives: one for all summands that have equal
/// loops and depend on equal kinds of variables. Sums inside products and functions become totals
/// of the system. `known`: what symbols stand for. Precondition: Declarations::meant(). Throws as
/// loop_terms() and value_of_term() do.
[[nodiscard]] std::vector<SystemSum> sums_of(System& system, const Declarations& names,
                                             const IndexedExpression& expression, Symbols known);

/// H or L, which may depend on the time.
[[nodiscard]] std::vector<SystemSum> sums_in_time(System& system, const Declarations& names,
                                                  const IndexedExpression& function);

}  // namespace hvi::gen
