// Products with powers in them.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/expr/expression.hpp"

namespace hvi::gen {

/// Returns the expression with x^2 for x*x, and x^3 for x^2*x: equal factors of a product come
/// once.
[[nodiscard]] Expression with_powers(Expression expression);

}  // namespace hvi::gen
