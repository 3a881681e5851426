// Which coefficients are the same, as far as that is proved.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/exact/numbers/number.hpp"

namespace hvi::gen {

/// Proved to be equal. NOTE: two numbers known by enclosures alone may be equal without a proof;
/// then neither function says so, and a plan must be right in both cases.
[[nodiscard]] bool equal(const Number& a, const Number& b);

/// Proved to be different.
[[nodiscard]] bool differ(const Number& a, const Number& b);

}  // namespace hvi::gen
