// Where expressions stand.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/expr/expression.hpp"

namespace hvi::gen {

/// An expression without ranges: what is made of parts of several texts stands in none of them.
[[nodiscard]] Expression without_places(Expression expression);

}  // namespace hvi::gen
