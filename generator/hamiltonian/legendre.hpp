// The Legendre transformation between Hamiltonians and Lagrangians in closed form. Where one is a
// polynomial of degree 2 in the momenta, the other is one in the velocities.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/read/lagrangian.hpp"

namespace hvi::gen {

/// Transforms H = p^T K p/2 + b p + U, with K, b and U any functions of q and t, to
///
///     L(q, v) = p v - H, where v = dH/dp,
///             = (v - b)^T K^-1 (v - b)/2 - U.
///
/// The velocity of x is called x_dot. Parameters with a value are replaced by it; the result keeps
/// the values. Equal H give equal expressions. Throws MathError, with the place of H, where H does
/// not have this form, and where K is singular; the message has the rank, or says that L vanishes
/// (Leok & Zhang, Example 1.1). Throws as gradient() does.
[[nodiscard]] Lagrangian legendre_transform(const Hamiltonian& hamiltonian);

/// Transforms L = v^T M v/2 + a v - U to H = p v - L = (p - a)^T M^-1 (p - a)/2 + U. The momentum
/// of x is called p_x. Throws as legendre_transform() of H does.
[[nodiscard]] Hamiltonian legendre_transform(const Lagrangian& lagrangian);

/// Throws as legendre_transform() of L does, but computes no H.
void check_regular(const Lagrangian& lagrangian);

}  // namespace hvi::gen
