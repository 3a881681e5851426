// The rank of H in the momenta, and of L in the velocities.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include "generator/read/lagrangian.hpp"

namespace hvi::gen {

/// Returns the rank of d2H/dp2, or of d2L/dv2, for almost all values of the variables and of
/// parameters without a value. Enclosures at a point prove that it is not less. Exact algebra
/// proves that it is not more: a constant vector belongs to each missing rank, or all larger minors
/// vanish. Derivatives that exist almost nowhere do not count: sqrt(p^2), which is |p|, has rank 0.
/// Returns nothing where the rank is not decided.
[[nodiscard]] std::optional<std::size_t> fibre_rank(const Hamiltonian& hamiltonian);
[[nodiscard]] std::optional<std::size_t> fibre_rank(const Lagrangian& lagrangian);

/// Throws MathError where d2H/dp2 is known to be singular, with its rank. With more nodes than
/// functions, (4.6e) has to determine the P from the V.
void check_fibre_rank(const Hamiltonian& hamiltonian, const std::optional<Place>& place);

}  // namespace hvi::gen
