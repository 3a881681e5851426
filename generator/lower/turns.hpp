// Derivatives by turns of bodies.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/ir/system.hpp"

namespace hvi::gen {

/// Derivatives by the degrees of freedom, from derivatives by all coordinates: by numbers as they
/// are, and of each rotation D_a = sum_ij df/dR_ij (R e_a)_ij, the derivatives of
/// f(R exp(hat eta)) by eta at 0. With G_ij = df/dR_ij these are the parts of R^T G - G^T R.
/// Preconditions: the system is written out, and `by_entries` are as many as its coordinates are.
[[nodiscard]] std::vector<Scaled> by_turns(System& system, const std::vector<Scaled>& by_entries);

}  // namespace hvi::gen
