// Divisors of polynomials, whatever their coefficients are known by.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/exact/algebra/number_polynomial.hpp"

namespace hvi::gen {

/// Arithmetic in which degrees depend on "is it zero?". Exact coefficients decide it. One that has
/// enclosures alone is taken for zero where some 150 digits do not tell it from zero; from then on
/// `proved` is false.
class PolynomialArithmetic {
public:
    [[nodiscard]] bool proved() const { return proved_; }

    [[nodiscard]] bool is_zero(const Number& number);

    /// Without zeros at the end.
    [[nodiscard]] NumberPolynomial trimmed(NumberPolynomial polynomial);
    /// a + factor b
    [[nodiscard]] NumberPolynomial sum(const NumberPolynomial& a, const Number& factor,
                                       const NumberPolynomial& b);
    /// Precondition: the divisor is not zero.
    [[nodiscard]] Division divide(const NumberPolynomial& dividend,
                                  const NumberPolynomial& divisor);
    /// The greatest common divisor, monic, or zero.
    [[nodiscard]] NumberPolynomial gcd(const NumberPolynomial& a, const NumberPolynomial& b);
    /// What is left of `a` without its common divisor with b. Precondition: a is not zero.
    [[nodiscard]] NumberPolynomial without(const NumberPolynomial& a, const NumberPolynomial& b);
    /// With the same roots, each once. Precondition: not zero.
    [[nodiscard]] NumberPolynomial squarefree(const NumberPolynomial& polynomial);

private:
    bool proved_ = true;
};

/// With rational numbers that stand in no field.
[[nodiscard]] NumberPolynomial numbers(const RationalPolynomial& polynomial);

[[nodiscard]] NumberPolynomial derivative(const NumberPolynomial& polynomial);

/// Proven bounds of the values on a ball. Precondition: no free parameter.
[[nodiscard]] Ball enclosure(const NumberPolynomial& polynomial, const Ball& argument,
                             Precision bits);

/// How many terms its normal form has, as what arithmetic with it costs; 0 for an enclosure.
[[nodiscard]] std::size_t term_count(const Number& number);
[[nodiscard]] std::size_t term_count(const NumberMatrix& rows);  ///< of all of them

/// By enclosures, so that the numbers may stand in different fields. Precondition: they differ.
[[nodiscard]] bool is_less(const Number& left, const Number& right);

/// The positive real roots of a polynomial in z^2 that are less than a bound, ascending: given by
/// the polynomial in t = z^2. Exact over Q where `real_roots` is, and where the polynomial in t has
/// short exact coefficients and a degree of at most 2; else enclosed by isolating balls.
/// Preconditions: the polynomial in t is square-free, not zero at 0, and without free parameters.
[[nodiscard]] NumberVector roots_in_square(const NumberPolynomial& polynomial, long bound);

}  // namespace hvi::gen
