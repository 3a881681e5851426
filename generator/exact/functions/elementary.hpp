// Elementary functions of numbers, by their names.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "generator/exact/numbers/ground.hpp"

namespace hvi::gen {

/// A function of expr/functions.def of a number. Throws MathError where the value is not real, and
/// InputError for a tangent that is infinite.
[[nodiscard]] Number elementary(const std::string& name, const Number& argument,
                                const Ground& ground);

/// asin, acos and atan: exact where the angle is a multiple of pi by a fraction with a small
/// denominator, since closed forms have no other angles (CONTRACT.md); enclosed elsewhere.
[[nodiscard]] Number arcsine(const Number& sine, const Ground& ground);
[[nodiscard]] Number arccosine(const Number& cosine, const Ground& ground);
[[nodiscard]] Number arctangent(const Number& tangent, const Ground& ground);

/// asinh, acosh and atanh: exact where they are logarithms of rational numbers; enclosed elsewhere.
[[nodiscard]] Number area_sine(const Number& sine, const Ground& ground);
[[nodiscard]] Number area_cosine(const Number& cosine, const Ground& ground);
[[nodiscard]] Number area_tangent(const Number& tangent, const Ground& ground);

}  // namespace hvi::gen
