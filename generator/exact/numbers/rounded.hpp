// Numbers that are known to some digits only.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>

#include "generator/exact/numbers/verdict.hpp"
#include "generator/read/decimal.hpp"

namespace hvi::gen {

/// Returns an enclosure of all numbers that a decimal may have been rounded from: those that are
/// not further from it than half a unit of its last digit. A tableau whose decimals have up to 17
/// digits may also have been computed in doubles, where Python prints 1/6 as 0.16666666666666666.
/// Then all numbers also count that are not further than `spacing`/2 from the nearest double, where
/// `spacing` is that of doubles at the largest number of the tableau. The result has one enclosure
/// that never gets narrower: compare it with can_agree(). Precondition: `written` is rational.
[[nodiscard]] Number unrounded(const Number& written, const DecimalDigits& digits,
                               std::optional<double> spacing);

/// Largest number of digits that a double is printed with.
inline constexpr int most_digits_of_double = 17;

/// Returns the distance from a double's absolute value to the next one.
[[nodiscard]] double spacing_at(double value);

/// Returns how many bits tell apart numbers that so many decimal digits tell apart.
[[nodiscard]] Precision bits_for(int digits);

/// Returns whether the enclosures of two numbers meet, which may come from different fields.
[[nodiscard]] bool overlap(const Number& left, const Number& right, Precision bits);

/// Returns whether two numbers of one field, or without, can be equal as far as they are known. A
/// no is always proved; a yes is for exact numbers.
[[nodiscard]] Verdict can_agree(const Number& left, const Number& right, Precision bits);

/// Returns the largest n with |left - right| <= 10^-n/2 for all that the numbers can be; empty for
/// exact numbers that are equal. The numbers are as for can_agree().
[[nodiscard]] std::optional<long> common_places(const Number& left, const Number& right,
                                                Precision bits);

}  // namespace hvi::gen
