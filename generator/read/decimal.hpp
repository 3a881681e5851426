// Decimal numbers as the fractions that they are.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/expr/expression.hpp"

namespace hvi::gen {

/// The number written as `12`, `0.5`, `.5`, `1.` or `2.5e-3`, exactly and in lowest terms: 0.1 is
/// 1/10. Precondition: the place holds such a number. Throws InputError when it has more than 1000
/// digits or an exponent beyond 1000, which no method needs and which would only cost time.
[[nodiscard]] Expression read_decimal(const Place& place);

}  // namespace hvi::gen
