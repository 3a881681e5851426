// Field elements as quotients of sums, in the order in which they are written.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/exact/numbers/field.hpp"

namespace hvi::gen {

/// coefficient * product of powers of the transcendental generators * algebraic monomial. NOTE:
/// here an exponent k of a cosine generator cos(pi/n) stands for cos(k pi/n).
struct WrittenTerm {
    Rational coefficient;
    std::vector<int> powers;
    Monomial monomial;
};

/// (sum of numerator)/(sum of denominator): integer coefficients without a common divisor, the
/// first of the denominator positive, no algebraic generator in the denominator. The terms are
/// sorted by their exponents, so that one number has one text.
struct WrittenFraction {
    std::vector<WrittenTerm> numerator;
    std::vector<WrittenTerm> denominator;
};

/// Precondition: not zero.
[[nodiscard]] WrittenFraction written_fraction(const Element& argument);

void negate(std::vector<WrittenTerm>& terms);
[[nodiscard]] bool is_negative(const WrittenTerm& term);

}  // namespace hvi::gen
