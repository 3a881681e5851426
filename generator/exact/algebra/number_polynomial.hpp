// Polynomials in tau with exact coefficients, lowest first, without zeros at the end.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>

#include "generator/exact/algebra/number_vector.hpp"
#include "generator/exact/algebra/polynomial.hpp"

namespace hvi::gen {

/// Coefficients, lowest first. Zero has none.
using NumberPolynomial = NumberVector;

void trim(NumberPolynomial& polynomial);
[[nodiscard]] NumberPolynomial sum(const NumberPolynomial& a, const NumberPolynomial& b);
[[nodiscard]] NumberPolynomial product(const NumberPolynomial& a, const NumberPolynomial& b);
[[nodiscard]] NumberPolynomial scaled(const NumberPolynomial& a, const Number& factor);
/// Returns tau times the polynomial.
[[nodiscard]] NumberPolynomial shifted(NumberPolynomial polynomial);
[[nodiscard]] NumberPolynomial power_of(const NumberPolynomial& base, unsigned exponent);
[[nodiscard]] Number value_at(const NumberPolynomial& polynomial, const Number& point);

struct Division {
    NumberPolynomial quotient, remainder;
};
/// Divides with remainder. Precondition: the divisor is not zero.
[[nodiscard]] Division divide(const NumberPolynomial& dividend, const NumberPolynomial& divisor);

/// Returns the greatest common divisor, but for a constant factor. Precondition: one of them is not
/// zero.
[[nodiscard]] NumberPolynomial gcd(NumberPolynomial a, NumberPolynomial b);

/// Factors with u a + v b = 1, deg u < deg b and deg v < deg a; empty when a and b are not coprime.
/// Precondition: neither is constant.
struct Bezout {
    NumberPolynomial u, v;
};
[[nodiscard]] std::optional<Bezout> bezout(const NumberPolynomial& a, const NumberPolynomial& b);

/// Return the polynomial over Q, when its coefficients are rational, and back.
[[nodiscard]] std::optional<RationalPolynomial> over_rationals(const NumberPolynomial& polynomial);
[[nodiscard]] NumberPolynomial with_numbers(const RationalPolynomial& polynomial,
                                            const Ground& ground);

/// A factorization polynomial = factor * product of parts. The parts are monic and, over the real
/// numbers, coprime to each other; they have degree 1, degree 2 without a real root, or degree 3 or
/// more and are irreducible over Q.
struct Factorization {
    Number factor;
    struct Part {
        NumberPolynomial polynomial;
        unsigned multiplicity;
    };
    std::vector<Part> parts;
};
/// Returns the factorization. Empty for coefficients that are not exact or have free parameters,
/// and for polynomials of degree 3 or more that are not rational. Precondition: not zero.
[[nodiscard]] std::optional<Factorization> factorize(const NumberPolynomial& polynomial,
                                                     const Ground& ground);

}  // namespace hvi::gen
