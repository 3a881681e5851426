// Orders of splittings for parts of different sizes.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "generator/exact/methods/splitting.hpp"

namespace hvi::gen {

/// The largest order that is looked for.
inline constexpr std::size_t longest_splitting_order = 22;

/// Returns the orders (p_1, p_2, ...) of a splitting of A + eps B: a step has the Hamiltonian A +
/// eps B + O(eps h^p_1 + eps^2 h^p_2 + ...). The list ends where an order is that of the splitting,
/// below which none falls.
///
/// The conditions are that in the logarithm of exp(a_1 A) exp(b_1 B) ... exp(a_k+1 A), with letters
/// that do not commute, the words of j letters B and less than p_j + 1 letters have the coefficient
/// 0 (Blanes et al., Appl. Numer. Math. 68 (2013) 58, Section 2). They are decided to 50 digits.
[[nodiscard]] std::vector<std::size_t> splitting_orders(const Splitting& splitting);

}  // namespace hvi::gen
