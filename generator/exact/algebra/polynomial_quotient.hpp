// Rational functions of z, to be written and drawn.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>

#include "generator/exact/algebra/number_vector.hpp"

namespace hvi::gen {

/// A rational function: two polynomials by their coefficients, lowest first.
struct PolynomialQuotient {
    NumberVector numerator, denominator;
};

/// Returns a function of the symbol z; over Q it has coprime integers. Empty where a coefficient
/// has no closed form. Precondition: one coefficient is 1.
[[nodiscard]] std::optional<Expression> closed_form(const PolynomialQuotient& quotient);

/// Returns the value, rounded to a double that can be plotted; empty where it is infinite or nearly
/// so. Precondition: no free parameter.
[[nodiscard]] std::optional<double> value_at(const PolynomialQuotient& quotient, double z);

}  // namespace hvi::gen
