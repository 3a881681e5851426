// Rational functions of cosines and sines, in tangents of half the angles.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "generator/exact/numbers/field.hpp"

namespace hvi::gen {

/// Returns the element with t = tan(angle/2) for the variable in the place of each cos(angle), and
/// without sines: cos = (1 - t^2)/(1 + t^2) and sin = 2 t/(1 + t^2). `angles` are the variables of
/// cosines of parameters, all that occur.
[[nodiscard]] Element in_tangents(const Element& element, const std::vector<std::size_t>& angles);

/// Returns 1 + t^2, for t = variable number t.
[[nodiscard]] IntegerMultivariate secant_squared(std::size_t t);

/// Divides all polynomials by 1 + t^2 as often as it divides all of them. Returns how often that
/// is.
unsigned without_secants(Element::Terms& polynomials, std::size_t t);

}  // namespace hvi::gen
