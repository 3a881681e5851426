// Polynomials in z by polynomials in t = z^2, and their signs.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/exact/algebra/polynomial_arithmetic.hpp"

namespace hvi::gen {

/// Return the parts of P(z) = even(z^2) + z odd(z^2), as polynomials in t = z^2.
[[nodiscard]] NumberPolynomial even(const NumberPolynomial& polynomial);
[[nodiscard]] NumberPolynomial odd(const NumberPolynomial& polynomial);

/// Returns a number between two others, exactly. Throws MathError when they are not told apart.
[[nodiscard]] Ball between(const Number& low, const Number& high);

/// Returns the sign of a polynomial in t at t = z^2. Throws MathError where it is zero, or nearly
/// so.
[[nodiscard]] int sign_at(const NumberPolynomial& polynomial, const Ball& z);

}  // namespace hvi::gen
