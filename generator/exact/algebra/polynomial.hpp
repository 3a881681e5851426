// Polynomials with rational coefficients and their real roots.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <flint/fmpq_poly.h>

#include <optional>
#include <string>
#include <vector>

#include "generator/exact/algebra/number_vector.hpp"
#include "generator/exact/numbers/ball.hpp"
#include "generator/exact/numbers/ground.hpp"

namespace hvi::gen {

/// A polynomial over Q: FLINT's, with value semantics.
class RationalPolynomial {
public:
    RationalPolynomial() { fmpq_poly_init(polynomial_); }
    explicit RationalPolynomial(long constant) : RationalPolynomial() {
        fmpq_poly_set_si(polynomial_, constant);
    }
    RationalPolynomial(const RationalPolynomial& other) : RationalPolynomial() {
        fmpq_poly_set(polynomial_, other.polynomial_);
    }
    RationalPolynomial& operator=(RationalPolynomial other) noexcept {
        fmpq_poly_swap(polynomial_, other.polynomial_);
        return *this;
    }
    ~RationalPolynomial() { fmpq_poly_clear(polynomial_); }

    /// Returns the polynomial x.
    [[nodiscard]] static RationalPolynomial variable();

    [[nodiscard]] fmpq_poly_struct* get() { return polynomial_; }
    [[nodiscard]] const fmpq_poly_struct* get() const { return polynomial_; }

    [[nodiscard]] long degree() const { return fmpq_poly_degree(polynomial_); }  ///< -1 for zero

    /// Returns the coefficient of x^index as `-2/3`; `fraction` is a text that `Ground::rational`
    /// takes.
    [[nodiscard]] std::string coefficient(long index) const;
    void set_coefficient(long index, const std::string& fraction);

    [[nodiscard]] RationalPolynomial derivative() const;

    /// Returns the integral over [0, 1], as `-2/3`.
    [[nodiscard]] std::string integral_over_unit_interval() const;

    /// Returns the polynomial at an affine argument: P(slope x + offset).
    [[nodiscard]] RationalPolynomial at_affine(long slope, long offset) const;

    friend RationalPolynomial operator+(const RationalPolynomial& a, const RationalPolynomial& b);
    friend RationalPolynomial operator-(const RationalPolynomial& a, const RationalPolynomial& b);
    friend RationalPolynomial operator*(const RationalPolynomial& a, const RationalPolynomial& b);

private:
    fmpq_poly_t polynomial_;
};

/// Returns the polynomial divided by its leading coefficient. Precondition: not zero.
[[nodiscard]] RationalPolynomial monic(RationalPolynomial polynomial);

/// Returns the integral from 0 on.
[[nodiscard]] RationalPolynomial antiderivative(const RationalPolynomial& polynomial);

[[nodiscard]] bool operator==(const RationalPolynomial& a, const RationalPolynomial& b);

/// Returns a modulo P.
[[nodiscard]] RationalPolynomial remainder(const RationalPolynomial& a,
                                           const RationalPolynomial& P);

/// Returns 1/a modulo P, when they have no common root.
[[nodiscard]] std::optional<RationalPolynomial> inverse_modulo(const RationalPolynomial& a,
                                                               const RationalPolynomial& P);

/// Returns Legendre's polynomial P_degree on [-1, 1].
[[nodiscard]] RationalPolynomial legendre(unsigned degree);

/// Returns Chebyshev's polynomial T_degree on [-1, 1].
[[nodiscard]] RationalPolynomial chebyshev_t(unsigned degree);

/// Returns the monic polynomial on [-1, 1] whose roots are the nodes of Chebyshev's quadrature with
/// equal weights: G_s of (4.20), the polynomial part of x^s exp(-s (1/(2*3 x^2) + 1/(4*5 x^4) +
/// ...)).
[[nodiscard]] RationalPolynomial chebyshev_equal_weights(unsigned degree);

/// A monic irreducible factor over Q, and how often it divides.
struct IrreducibleFactor {
    RationalPolynomial polynomial;
    unsigned multiplicity = 1;
};

/// Returns the monic irreducible factors, in FLINT's order, which does not change from run to run.
/// Precondition: not zero.
[[nodiscard]] std::vector<IrreducibleFactor>
irreducible_factors(const RationalPolynomial& polynomial);

/// Returns proven bounds of the values on a ball.
[[nodiscard]] Ball enclosure(const RationalPolynomial& polynomial, const Ball& argument,
                             Precision bits);

/// Returns all real roots, each once, ascending. Exact for factors of degree 1, 2, and 4 where
/// shifting the variable makes them polynomials in its square; otherwise enclosed by isolating
/// balls. Precondition: not zero.
[[nodiscard]] NumberVector real_roots(const RationalPolynomial& polynomial, const Ground& ground);

}  // namespace hvi::gen
