// Numbers in the texts of records.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "generator/exact/numbers/number.hpp"

namespace hvi::gen {

/// Returns the closed form, `1/2+1/6*sqrt(3)`; for a number without one 50 digits behind a `~`.
[[nodiscard]] std::string dump(const Number& number);

}  // namespace hvi::gen
