// Properties that a partitioned Runge-Kutta method preserves.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>

#include "generator/exact/methods/number_stages.hpp"

namespace hvi::gen {

// For a RoundedMethod each function answers whether each condition by itself can hold, for some of
// the numbers that the coefficients can be: a no is proved, a yes is not. Residuals are those of
// the written coefficients.

/// Return whether every step is a symplectic map by b~ = b and
///
///     b_i a~_ij + b_j a_ji - b_i b_j = 0    for all i, j
///
/// (Hairer, Lubich & Wanner, Geometric Numerical Integration, Theorem VI.4.6). Computed with a
/// `node_polynomial` over Q, else with the coefficients. The conditions are sufficient for every H,
/// and necessary for methods without superfluous stages.
[[nodiscard]] Verdict is_symplectic(const Tableau& tableau);
[[nodiscard]] Verdict is_symplectic(const PartitionedMethod& method);
[[nodiscard]] Verdict is_symplectic(const RoundedMethod& method);

/// The first of these conditions that fails, and its residual; empty where all hold.
struct SymplecticDefect {
    std::size_t i = 0;             ///< 0-based
    std::optional<std::size_t> j;  ///< empty for b~_i - b_i
    Number residual;
};
[[nodiscard]] std::optional<SymplecticDefect> symplectic_defect(const PartitionedMethod& method);
[[nodiscard]] std::optional<SymplecticDefect> symplectic_defect(const RoundedMethod& method);

/// Return whether a step with -h leads back, by a permutation sigma of the stages with
///
///     b_sigma(i) = b_i,    a_sigma(i)sigma(j) + a_ij = b_j,    the same with tildes
///
/// (Geometric Numerical Integration, Theorem V.2.3, where sigma(i) = s + 1 - i).
[[nodiscard]] Verdict is_symmetric(const Tableau& tableau);
[[nodiscard]] Verdict is_symmetric(const PartitionedMethod& method);
[[nodiscard]] Verdict is_symmetric(const RoundedMethod& method);

/// Return whether q and p are treated alike: b~ = b and A~ = A.
[[nodiscard]] Verdict is_runge_kutta(const Tableau& tableau);
[[nodiscard]] Verdict is_runge_kutta(const PartitionedMethod& method);
[[nodiscard]] Verdict is_runge_kutta(const RoundedMethod& method);

/// Return whether b~ = b, so that all linear invariants of (q, p) are conserved (Geometric
/// Numerical Integration, Theorem IV.1.5 and the remark after it).
[[nodiscard]] Verdict has_common_weights(const Tableau& tableau);
[[nodiscard]] Verdict has_common_weights(const PartitionedMethod& method);
[[nodiscard]] Verdict has_common_weights(const RoundedMethod& method);

}  // namespace hvi::gen
