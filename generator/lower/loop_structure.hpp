// Structure of a system with loops, as far as its graph proves it, and its second derivatives.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/ir/system.hpp"

namespace hvi::gen {

/// The system with its structure: H = T(p) + U(q), T = p^T K p/2, whether U is quadratic, and what
/// is coupled in d2U/dq2: read off the summands, never off sizes. Where T is quadratic d2H/dq2 is
/// there too, as Newton's method takes it. Precondition: slopes, and sites of a lattice, are there.
[[nodiscard]] System with_loop_structure(System system);

/// The system with HessianProducts of all of d2H, for Newton's method where stages have momenta.
[[nodiscard]] System with_products_of_pairs(System system);

}  // namespace hvi::gen
