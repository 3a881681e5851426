// Field elements as quotients of sums, in their written order.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/exact/numbers/field.hpp"

namespace hvi::gen {

/// A term coefficient * product of powers of the transcendental generators * algebraic monomial.
/// NOTE: here an exponent k of a cosine generator cos(pi/n) stands for cos(k pi/n).
struct WrittenTerm {
    Rational coefficient;
    std::vector<int> powers;
    Monomial monomial;
};

/// A fraction (sum of numerator)/(sum of denominator): integer coefficients without a common
/// divisor, the first of the denominator positive, no algebraic generator in the denominator. The
/// terms are sorted by their exponents, so that one number has one text.
struct WrittenFraction {
    std::vector<WrittenTerm> numerator;
    std::vector<WrittenTerm> denominator;
};

/// Returns an element as a fraction. Precondition: not zero.
[[nodiscard]] WrittenFraction written_fraction(const Element& argument);

void negate(std::vector<WrittenTerm>& terms);
[[nodiscard]] bool is_negative(const WrittenTerm& term);

}  // namespace hvi::gen
