// Divisors of polynomials, with exact coefficients or enclosures.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/exact/algebra/number_polynomial.hpp"

namespace hvi::gen {

/// Arithmetic in which degrees depend on "is it zero?". Exact coefficients decide it. A coefficient
/// that has enclosures alone is taken for zero where some 150 digits do not tell it from zero; from
/// then on `proved` is false.
class PolynomialArithmetic {
public:
    [[nodiscard]] bool proved() const { return proved_; }

    [[nodiscard]] bool is_zero(const Number& number);

    /// Returns the polynomial without zeros at the end.
    [[nodiscard]] NumberPolynomial trimmed(NumberPolynomial polynomial);
    /// Returns a + factor b.
    [[nodiscard]] NumberPolynomial sum(const NumberPolynomial& a, const Number& factor,
                                       const NumberPolynomial& b);
    /// Divides with remainder. Precondition: the divisor is not zero.
    [[nodiscard]] Division divide(const NumberPolynomial& dividend,
                                  const NumberPolynomial& divisor);
    /// Returns the greatest common divisor, monic, or zero.
    [[nodiscard]] NumberPolynomial gcd(const NumberPolynomial& a, const NumberPolynomial& b);
    /// Returns `a` divided by its common divisor with b. Precondition: a is not zero.
    [[nodiscard]] NumberPolynomial without(const NumberPolynomial& a, const NumberPolynomial& b);
    /// Returns the polynomial with the same roots, each once. Precondition: not zero.
    [[nodiscard]] NumberPolynomial squarefree(const NumberPolynomial& polynomial);

private:
    bool proved_ = true;
};

/// Returns the polynomial with rational numbers that stand in no field.
[[nodiscard]] NumberPolynomial numbers(const RationalPolynomial& polynomial);

[[nodiscard]] NumberPolynomial derivative(const NumberPolynomial& polynomial);

/// Returns proven bounds of the values on a ball. Precondition: no free parameter.
[[nodiscard]] Ball enclosure(const NumberPolynomial& polynomial, const Ball& argument,
                             Precision bits);

/// Return how many terms the normal form of a number has, which is the cost of arithmetic with it;
/// 0 for an enclosure.
[[nodiscard]] std::size_t term_count(const Number& number);
[[nodiscard]] std::size_t term_count(const NumberMatrix& rows);  ///< of all entries

/// Returns whether left < right, by enclosures, so that the numbers may stand in different fields.
/// Precondition: they differ.
[[nodiscard]] bool is_less(const Number& left, const Number& right);

/// Returns the positive real roots of a polynomial in z^2 that are less than a bound, ascending;
/// `polynomial` is in t = z^2. Exact over Q where `real_roots` is, and where the polynomial in t
/// has short exact coefficients and a degree of at most 2; else enclosed by isolating balls.
/// Preconditions: the polynomial in t is square-free, not zero at 0, and without free parameters.
[[nodiscard]] NumberVector roots_in_square(const NumberPolynomial& polynomial, long bound);

}  // namespace hvi::gen
