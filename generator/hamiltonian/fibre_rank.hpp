// How many directions of the momenta H knows, and of the velocities L.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include "generator/read/lagrangian.hpp"

namespace hvi::gen {

/// The rank of d2H/dp2, or of d2L/dv2, for almost all values of the variables and of parameters
/// without a value: not less by enclosures at a point, not more by exact algebra, as a constant
/// vector belongs to each missing one, or as all larger minors vanish. What exists almost nowhere
/// does not count: of sqrt(p^2), which is |p|, the rank is 0. Empty where that does not decide it.
[[nodiscard]] std::optional<std::size_t> fibre_rank(const Hamiltonian& hamiltonian);
[[nodiscard]] std::optional<std::size_t> fibre_rank(const Lagrangian& lagrangian);

/// With more nodes than functions (4.6e) has to determine the P from the V. Throws MathError where
/// d2H/dp2 is known to be singular, with its rank.
void check_fibre_rank(const Hamiltonian& hamiltonian, const std::optional<Place>& place);

}  // namespace hvi::gen
