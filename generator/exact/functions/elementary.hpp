// Elementary functions of numbers, by their names.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "generator/exact/algebra/number_vector.hpp"
#include "generator/exact/numbers/ground.hpp"

namespace hvi::gen {

/// Returns an analytic function of expr/functions.def of a number. Throws MathError where the value
/// is not real, and InputError for a tangent that is infinite.
[[nodiscard]] Number elementary(const std::string& name, const Number& argument,
                                const Ground& ground);

/// Returns atan2, min, max, abs or sign of numbers. Comparisons are proved by the field or by
/// enclosures. Throws MathError for the angle of the origin, and where a comparison is not decided.
[[nodiscard]] Number elementary(const std::string& name, const NumberVector& arguments,
                                const Ground& ground);

/// Returns whether a < b or, unless it is strict, a = b. Throws as the function above.
[[nodiscard]] bool compares(bool is_strict, const Number& a, const Number& b);

/// Return asin, acos and atan: exact where the angle is a multiple of pi by a fraction with a small
/// denominator, since closed forms have no other angles (CONTRACT.md); enclosed elsewhere.
[[nodiscard]] Number arcsine(const Number& sine, const Ground& ground);
[[nodiscard]] Number arccosine(const Number& cosine, const Ground& ground);
[[nodiscard]] Number arctangent(const Number& tangent, const Ground& ground);

/// Return asinh, acosh and atanh: exact where they are logarithms of rational numbers; enclosed
/// elsewhere.
[[nodiscard]] Number area_sine(const Number& sine, const Ground& ground);
[[nodiscard]] Number area_cosine(const Number& cosine, const Ground& ground);
[[nodiscard]] Number area_tangent(const Number& tangent, const Ground& ground);

}  // namespace hvi::gen
