// How many directions of the momenta H knows, and of the velocities L.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include "generator/read/lagrangian.hpp"

namespace hvi::gen {

/// The rank of d2H/dp2, or of d2L/dv2, for almost all values of the variables and of parameters
/// without a value. It is found where a constant vector belongs to each missing one: not more by
/// exact algebra, not less by enclosures at a point. Empty where that does not decide it.
[[nodiscard]] std::optional<std::size_t> fibre_rank(const Hamiltonian& hamiltonian);
[[nodiscard]] std::optional<std::size_t> fibre_rank(const Lagrangian& lagrangian);

}  // namespace hvi::gen
