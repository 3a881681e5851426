// Derivatives through sums that other sums depend on.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/ir/system.hpp"

namespace hvi::gen {

/// Returns the roles of the input for a total of these sums.
[[nodiscard]] Roles roles_of_total(const Graph& graph, const std::vector<SystemSum>& sums);

/// Returns the system with the derivatives of its function through totals, by the chain rule in
/// reverse: from the last total down, each gets the derivative of the function by it once.
/// Derivatives that loops add up are further totals. The slopes by elements belong to sums of value
/// 0.
[[nodiscard]] System with_slopes_through_totals(System system);

/// Returns all totals that values of sums depend on, the last one first.
[[nodiscard]] std::vector<SystemTotal> totals_in(const System& system,
                                                 const std::vector<SystemSum>& sums);

/// Returns whether the function depends on totals. NOTE: invariants have some of their own.
[[nodiscard]] bool is_made_of_totals(const System& system);

}  // namespace hvi::gen
