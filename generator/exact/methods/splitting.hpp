// Splittings of H into parts whose flows are known: the order of the flows, and their lengths.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/exact/methods/tableau.hpp"
#include "generator/exact/numbers/ground.hpp"
#include "generator/read/method.hpp"

namespace hvi::gen {

/// The flow of A over a_1 h, of B over b_1 h, of A over a_2 h, ..., and of A over a_k+1 h, for H =
/// A + B. It is a palindrome, and the a and the b have the sum 1.
struct Splitting {
    NumberVector a;  ///< k + 1
    NumberVector b;  ///< k
    int digits = 0;  ///< digits of the decimals that they are; 0: they are exact
};

/// Returns the coefficients of a splitting by its name, on the field of `ground`. Precondition: the
/// name is one of the catalogue.
[[nodiscard]] Splitting splitting(const Ground& ground, const std::string& name);

/// Returns the steps of a composition of the map of first order, all flows one after the other,
/// with its adjoint, the same flows in reverse, that is this splitting for two parts:
/// gamma_1 = a_1, gamma_2k = b_k - gamma_2k-1, gamma_2k+1 = a_k+1 - gamma_2k. For more parts it has
/// the same order (McLachlan, SIAM J. Sci. Comput. 16 (1995) 151, Theorem 1).
[[nodiscard]] NumberVector substeps(const Splitting& splitting);

/// Returns the tableau of the splitting, with which it steps H = T(p) + U(q): A is T, and B is U.
/// Precondition: method.splitting has its name.
[[nodiscard]] Tableau splitting_tableau(const Ground& ground, const Method& method);

}  // namespace hvi::gen
