// Constants as sums of doubles.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>

#include "generator/exact/numbers/number.hpp"

namespace hvi::gen {

/// Returns a constant as a sum of doubles, the largest first, to 260 bits or so. Precondition: no
/// parameter.
[[nodiscard]] std::array<double, 5> expansion(const Number& constant);

}  // namespace hvi::gen
