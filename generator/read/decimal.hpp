// Decimal numbers as exact fractions.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "generator/expr/expression.hpp"

namespace hvi::gen {

/// Returns the number written as `12`, `0.5`, `.5`, `1.` or `2.5e-3`, exactly and in lowest terms:
/// 0.1 is 1/10. Precondition: the place holds such a number. Throws InputError for more than 1000
/// digits or an exponent beyond 1000, which no method needs and which would only cost time.
[[nodiscard]] Expression read_decimal(const Place& place);

/// Digits of a decimal that may be a rounded number.
struct DecimalDigits {
    int significant = 0;  ///< from the first digit that is not 0 to the last one written
    long last_place = 0;  ///< the power of ten of the last digit: -2 for 0.25 and for 1e-2
};

/// Returns the digits of a text that is one decimal, perhaps with a sign, and has a point or an
/// exponent; empty for any other text. Whole numbers are no decimals.
[[nodiscard]] std::optional<DecimalDigits> decimal_digits(std::string_view text);

}  // namespace hvi::gen
