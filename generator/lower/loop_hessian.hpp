// What a system with loops is, as far as its graph proves it, and its second derivatives.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "generator/ir/properties.hpp"
#include "generator/lower/site_force.hpp"

namespace hvi::gen {

/// H = T(p) + U(q), T = p^T K p/2, whether U is quadratic, and what is coupled in d2U/dq2: read off
/// the summands, never off sizes. The values that this takes are added to the graph. `sites` is
/// the system seen from its sites, where it is a lattice.
[[nodiscard]] SystemProperties properties(LoopSystem& system,
                                          const std::optional<SiteSystem>& sites);

/// An entry of d2H/dq2: a summand's second derivative by two of its elements.
struct LoopEntry {
    std::size_t row = 0, column = 0;  ///< accesses
    Scaled value;
};

/// The entries of one sum, within its loops; those below the diagonal too.
struct LoopEntries {
    std::vector<Loop> loops;
    std::vector<std::size_t> accesses;
    std::vector<LoopEntry> entries;
};

/// d2H/dq2 as Newton's method takes it.
struct LoopHessian {
    std::vector<LoopEntries> entries;  ///< where it has them
    /// Else sums whose derivatives `by_q` are, together, its product with a vector, the elements of
    /// which are accesses too: FamilyKind::direction.
    std::vector<LoopSum> products;
};

/// Added to the graph. Precondition: H is separable; the form is not dense.
[[nodiscard]] LoopHessian loop_hessian(LoopSystem& system, HessianForm form);

}  // namespace hvi::gen
