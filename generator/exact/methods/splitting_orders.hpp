// Orders of splittings for parts of different sizes.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/exact/methods/splitting.hpp"

namespace hvi::gen {

/// Returns the orders (p_1, p_2, ...) of a splitting of A + eps B: its steps have the Hamiltonian A +
/// eps B + O(eps h^p_1 + eps^2 h^p_2 + ...), with orders that do not fall below the last one, which
/// is the order of the splitting. The conditions are the coefficients of the words with one B, two
/// Bs and so on in the logarithm of exp(a_1 A) exp(b_1 B) ... exp(a_k+1 A), whose letters do not
/// commute (Blanes et al., Appl. Numer. Math. 68 (2013) 58, Section 2). Coefficients below 10^-50
/// are taken for zero where they are decimals of some 57 digits. `longest` bounds p_1.
[[nodiscard]] std::vector<std::size_t> orders(const Splitting& splitting, std::size_t longest);

}  // namespace hvi::gen
