// Exact numbers of doubles.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/exact/numbers/number.hpp"

namespace hvi::gen {

/// Returns the double, exactly. Precondition: it is finite.
[[nodiscard]] Number exact_number(double value);

}  // namespace hvi::gen
