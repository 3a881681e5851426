// Derivatives by turns of bodies.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/ir/system.hpp"

namespace hvi::gen {

/// Returns derivatives by the degrees of freedom, from derivatives by all coordinates. Derivatives
/// by numbers stay. For each rotation they are D_a = sum_ij df/dR_ij (R e_a)_ij, the derivatives of
/// f(R exp(hat eta)) by eta at 0. With G_ij = df/dR_ij these are the entries of R^T G - G^T R.
/// Preconditions: the system is written out, and `by_entries` has as many entries as there are
/// coordinates.
[[nodiscard]] std::vector<Scaled> by_turns(System& system, const std::vector<Scaled>& by_entries);

}  // namespace hvi::gen
