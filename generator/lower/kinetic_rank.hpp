// The rank of d2H/dp2.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include "generator/ir/system.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

/// Of d2H/dp2 for almost all q, p, t and parameters: what these make singular at single values is
/// not. Regular where enclosures prove it at one point, else by exact elimination with all of them
/// for free symbols. Empty where an entry is too long to be written, or beyond that arithmetic.
[[nodiscard]] std::optional<std::size_t> kinetic_rank(const System& system);

/// With more nodes than functions (4.6e) has to determine the P from the V. Throws MathError where
/// it is known to be singular, with its rank, and leaves rows of zeros to check_general_form().
void check_kinetic_rank(const System& system, const std::optional<Place>& place);

}  // namespace hvi::gen
