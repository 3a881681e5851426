// The rank of the matrix of a quadratic kinetic energy.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include "generator/ir/system.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

/// Of K in H = p^T K p/2 + U(q), by exact elimination with the parameters for free symbols: what
/// they make singular at single values is not. Empty where an entry is too long to be written.
/// Precondition: kinetic_is_quadratic.
[[nodiscard]] std::optional<std::size_t> kinetic_rank(const System& system);

/// With more nodes than functions (4.6e) has to determine the P from the V. Throws MathError where
/// K is known to be singular, with its rank. Precondition as above.
void check_kinetic_rank(const System& system, const std::optional<Place>& place);

}  // namespace hvi::gen
