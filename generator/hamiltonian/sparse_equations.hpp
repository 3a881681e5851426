// Homogeneous linear equations with few entries each.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <vector>

#include "generator/hamiltonian/algebra.hpp"

namespace hvi::gen {

/// A vector, without its zeros.
using SparseVector = std::map<std::size_t, GiNaC::ex>;

/// It is not known whether an entry is zero.
struct UndecidedEntry {
    std::size_t column;
};

/// Gauss and Jordan's elimination, in general position of parameters. Each equation is solved for
/// the first of its unknowns, so that those which are free stand as far behind as possible. All
/// pivots are proved not to vanish.
class SparseEquations {
public:
    explicit SparseEquations(const Algebra& algebra) : algebra_(algebra) {}

    /// Whether it says something new. Throws UndecidedEntry.
    [[nodiscard]] bool insert(SparseVector row);

    /// What is left of the vector where those inserted are zero: in unknowns that are free.
    [[nodiscard]] SparseVector reduced(SparseVector row) const;

    /// A basis of the vectors with so many entries that solve all; each is 1 at the last of its
    /// own, where the others are 0.
    [[nodiscard]] std::vector<SparseVector> solutions(std::size_t unknowns);

    /// The unknowns that are solved for.
    [[nodiscard]] std::vector<std::size_t> pivots() const;

private:
    [[nodiscard]] bool is_zero(std::size_t column, const GiNaC::ex& entry) const;

    const Algebra& algebra_;
    std::map<std::size_t, SparseVector> pivots_;  ///< by their first unknown, where they are 1
};

}  // namespace hvi::gen
