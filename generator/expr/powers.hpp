// Products with powers in them.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/expr/expression.hpp"

namespace hvi::gen {

/// The expression with x^2 for x*x, and x^3 for x^2*x: factors of a product that are equal come
/// once.
[[nodiscard]] Expression with_powers(Expression expression);

}  // namespace hvi::gen
