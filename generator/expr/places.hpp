// Places of expressions.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/expr/expression.hpp"

namespace hvi::gen {

/// Returns the expression without ranges: parts of several texts make an expression that stands in
/// none.
[[nodiscard]] Expression without_places(Expression expression);

}  // namespace hvi::gen
