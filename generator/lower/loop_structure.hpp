// Structure of a system with loops, as far as its graph proves it, and its second derivatives.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/ir/system.hpp"

namespace hvi::gen {

/// Returns the system with its structure: H = T(p) + U(q), T = p^T K p/2, whether U is quadratic,
/// and the couplings in d2U/dq2, all read off the summands, never off sizes. Second derivatives are
/// included unless H is made of totals. Preconditions: sums have loops; slopes, and the Sites of a
/// lattice, are there.
[[nodiscard]] System with_structure_of_sums(System system);

}  // namespace hvi::gen
