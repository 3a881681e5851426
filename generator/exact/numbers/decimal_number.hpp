// Exact numbers from decimals.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string_view>

#include "generator/exact/numbers/number.hpp"

namespace hvi::gen {

/// Returns the exact value of a decimal. Precondition: it is one as `-1.25`.
[[nodiscard]] Number decimal_number(std::string_view text);

}  // namespace hvi::gen
