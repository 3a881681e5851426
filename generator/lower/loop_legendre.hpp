// The Hamiltonian of a Lagrangian whose sums stay loops.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/ir/system.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

/// Returns the system of H = p v - L, where L = T(v) - U(q, t) and T is the sum of m v^2/2 over all
/// velocities. Each m depends on parameters and on the indices of its velocity: then p = m v, and H
/// is made of sums again. Invariants and initial values are in momenta, too. Throws NoLoops, with
/// `place`, for any other L, and for initial velocities in a file.
[[nodiscard]] System legendre_transform(System lagrangian, const Place& place);

}  // namespace hvi::gen
