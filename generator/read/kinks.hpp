// Kinks: places where a function is not smooth.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/expr/expression.hpp"

namespace hvi::gen {

/// Returns expressions that are zero where the function has a kink or a jump: x of abs(x) and
/// sign(x), a - b of min(a, b), max(a, b) and of a comparison in `if`. Each occurs once, in the
/// order of the function's text.
[[nodiscard]] std::vector<Expression> kinks_of(const Expression& function);

}  // namespace hvi::gen
