// What a partitioned Runge-Kutta method preserves.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/exact/number_stages.hpp"

namespace hvi::gen {

/// Whether every step is a symplectic map by b~ = b and
///
///     b_i a~_ij + b_j a_ji - b_i b_j = 0    for all i, j
///
/// (Hairer, Lubich & Wanner, Geometric Numerical Integration, Theorem VI.4.6). By computation:
/// with a `node_polynomial` over Q, else on the coefficients. Sufficient for every H; necessary for
/// methods without superfluous stages.
[[nodiscard]] Verdict is_symplectic(const Tableau& tableau);
[[nodiscard]] Verdict is_symplectic(const PartitionedMethod& method);

/// Whether a step with -h leads back, by a permutation sigma of the stages with
///
///     b_sigma(i) = b_i,    a_sigma(i)sigma(j) + a_ij = b_j,    the same with tildes
///
/// (Geometric Numerical Integration, Theorem V.2.3, where sigma(i) = s + 1 - i).
[[nodiscard]] Verdict is_symmetric(const Tableau& tableau);
[[nodiscard]] Verdict is_symmetric(const PartitionedMethod& method);

/// Whether q and p are treated alike: b~ = b and A~ = A.
[[nodiscard]] Verdict is_runge_kutta(const Tableau& tableau);
[[nodiscard]] Verdict is_runge_kutta(const PartitionedMethod& method);

}  // namespace hvi::gen
