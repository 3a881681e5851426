// Equality of coefficients, as far as it is proved.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/exact/numbers/number.hpp"

namespace hvi::gen {

/// Returns whether two numbers are proved to be equal. NOTE: two numbers known by enclosures alone
/// may be equal without a proof. Then neither function says so, and a plan must be right in both
/// cases.
[[nodiscard]] bool equal(const Number& a, const Number& b);

/// Returns whether two numbers are proved to be different.
[[nodiscard]] bool differ(const Number& a, const Number& b);

}  // namespace hvi::gen
