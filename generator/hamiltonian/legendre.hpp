// The Legendre transformation between Hamiltonians and Lagrangians, where it has a closed form:
// where one is a polynomial of degree 2 in the momenta, the other is one in the velocities.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/read/lagrangian.hpp"

namespace hvi::gen {

/// For H = p^T K p/2 + b p + U, with K, b and U any functions of q and t,
///
///     L(q, v) = p v - H, where v = dH/dp,
///             = (v - b)^T K^-1 (v - b)/2 - U.
///
/// The velocities are called x_dot of x, parameters that have a value are replaced by it, which the
/// record keeps, and the same H gives the same expression. Throws MathError, with the place of H,
/// where it is not of this form, and where K is singular: with its rank, and where L vanishes by
/// saying so (Leok & Zhang, Example 1.1). Throws what gradient() throws.
[[nodiscard]] Lagrangian legendre_transform(const Hamiltonian& hamiltonian);

/// For L = v^T M v/2 + a v - U the same: H = p v - L = (p - a)^T M^-1 (p - a)/2 + U. The momenta
/// are called p_x of x.
[[nodiscard]] Hamiltonian legendre_transform(const Lagrangian& lagrangian);

/// Throws as legendre_transform() of L does, and computes no H.
void check_regular(const Lagrangian& lagrangian);

}  // namespace hvi::gen
