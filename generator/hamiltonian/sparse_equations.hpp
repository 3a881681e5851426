// Homogeneous linear equations with few entries each.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <vector>

#include "generator/hamiltonian/algebra.hpp"

namespace hvi::gen {

/// A vector without its zeros.
using SparseVector = std::map<std::size_t, GiNaC::ex>;

/// Thrown where an entry is not known to be zero or not.
struct UndecidedEntry {
    std::size_t column;
};

/// Gauss-Jordan elimination for parameters in general position. Each equation is solved for the
/// first of its unknowns, so that the last unknowns stay free. All pivots are proved not to vanish.
class SparseEquations {
public:
    explicit SparseEquations(const Algebra& algebra) : algebra_(algebra) {}

    /// Inserts an equation. Returns whether it is independent of the others. Throws UndecidedEntry.
    [[nodiscard]] bool insert(SparseVector row);

    /// Reduces a vector by the equations to the free unknowns.
    [[nodiscard]] SparseVector reduced(SparseVector row) const;

    /// Returns a basis of the solutions with `unknowns` entries. The last entry of each is 1, and
    /// the others are 0 there.
    [[nodiscard]] std::vector<SparseVector> solutions(std::size_t unknowns);

    /// Returns the unknowns that are solved for.
    [[nodiscard]] std::vector<std::size_t> pivots() const;

private:
    [[nodiscard]] bool is_zero(std::size_t column, const GiNaC::ex& entry) const;

    const Algebra& algebra_;
    std::map<std::size_t, SparseVector> pivots_;  ///< by their first unknown, where they are 1
};

}  // namespace hvi::gen
