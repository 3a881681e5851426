// Properties of the general Galerkin form for H = p^T K p/2 + U(q), where it is a Nystrom method.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/exact/methods/galerkin_rule.hpp"
#include "generator/exact/methods/properties.hpp"

namespace hvi::gen {

/// Returns whether b_i (bbar_j - abar_ij) = b_j (bbar_i - abar_ji) and bbar_i = b_i (1 - c_i), for
/// all i, j (Hairer, Lubich & Wanner, Geometric Numerical Integration, Theorem IV.2.5).
[[nodiscard]] Verdict is_symplectic(const GalerkinRule& rule);

/// Returns whether a permutation of the nodes has c_sigma(i) = 1 - c_i, b_sigma(i) = b_i and
/// n_sigma(i)sigma(j) = n_ji: then a step with -h leads back.
[[nodiscard]] Verdict is_symmetric(const GalerkinRule& rule);

}  // namespace hvi::gen
