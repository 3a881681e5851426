// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/methods/interpolation.hpp"

#include <arb_fmpz_poly.h>

#include "generator/exact/algebra/rational_matrix.hpp"
#include "generator/exact/numbers/number_value.hpp"
#include "generator/exact/numbers/rational.hpp"

namespace hvi::gen {

namespace {

/// Returns the coefficients of the interpolating polynomials: l_j(t) = sum_m v_m(c_j) t^m. With
/// P(t) - P(y) = (t - y) sum_m D_m(y) t^m, D_m the quotient of P and y^(m+1), l_j(t) = P(t)/((t -
/// c_j) P'(c_j)) has v_m = D_m/P' modulo P.
std::optional<std::vector<RationalPolynomial>> lagrange(const RationalPolynomial& P) {
    const auto scale = inverse_modulo(P.derivative(), P);
    if (!scale) { return std::nullopt; }
    std::vector<RationalPolynomial> result;
    for (slong m = 0; m < P.degree(); ++m) {
        RationalPolynomial D;
        fmpq_poly_shift_right(D.get(), P.get(), m + 1);
        result.push_back(remainder(D * *scale, P));
    }
    return result;
}

/// Returns the columns of M^-1: M = C V with the coefficients C of psi and V of powers of the
/// nodes.
std::optional<std::vector<RationalPolynomial>> columns(const std::vector<RationalPolynomial>& psi,
                                                       const RationalPolynomial& P) {
    const auto v = lagrange(P);
    const std::size_t s = psi.size();
    RationalMatrix C(s, s);
    for (std::size_t i = 0; i < s; ++i) {
        for (std::size_t m = 0; m < s; ++m) {
            fmpq_poly_get_coeff_fmpq(C.entry(i, m), psi[i].get(), static_cast<slong>(m));
        }
    }
    if (!v || fmpq_mat_inv(C.get(), C.get()) == 0) { return std::nullopt; }
    std::vector<RationalPolynomial> result(s);
    for (std::size_t i = 0; i < s; ++i) {
        for (std::size_t m = 0; m < s; ++m) {
            if (fmpq_is_zero(C.entry(m, i)) != 0) { continue; }
            RationalPolynomial term;
            fmpq_poly_scalar_mul_fmpq(term.get(), (*v)[m].get(), C.entry(m, i));
            result[i] = result[i] + term;
        }
    }
    return result;
}

/// Returns sum_i u_i times the integral of psi_i over [0,1].
RationalPolynomial weight(const std::vector<RationalPolynomial>& u,
                          const std::vector<RationalPolynomial>& psi) {
    RationalPolynomial result;
    for (std::size_t i = 0; i < u.size(); ++i) {
        RationalPolynomial integral;
        integral.set_coefficient(0, psi[i].integral_over_unit_interval());
        result = result + u[i] * integral;
    }
    return result;
}

/// A root of P and its minimal polynomial.
class Root {
public:
    Root(const Number& value, const std::vector<IrreducibleFactor>& factors)
        : value_(value), minimal_(minimal_polynomial(value, factors)) {}

    /// Returns the value of a polynomial at the root.
    [[nodiscard]] Number at(const RationalPolynomial& polynomial, const Ground& ground) const {
        const RationalPolynomial reduced = remainder(polynomial, minimal_);
        if (reduced.degree() <= 0) { return ground.rational(reduced.coefficient(0), "1"); }
        if (value_.value().element() != nullptr) { return horner(reduced, ground); }
        return number(Real([reduced, root = value_](Precision bits) {
            return hvi::gen::enclosure(reduced, enclosure(root, bits), bits);
        }));
    }

private:
    /// Returns the one factor that enclosures of its value do not keep from zero.
    static RationalPolynomial minimal_polynomial(const Number& root,
                                                 const std::vector<IrreducibleFactor>& factors) {
        for (Precision bits = first_precision; bits <= last_precision; bits *= 2) {
            const Ball ball = enclosure(root, bits);
            std::vector<const RationalPolynomial*> left;
            for (const IrreducibleFactor& factor : factors) {
                const RationalPolynomial& polynomial = factor.polynomial;
                if (hvi::gen::enclosure(polynomial, ball, bits).sign() == 0) {
                    left.push_back(&polynomial);
                }
            }
            if (left.size() == 1) { return *left.front(); }
        }
        throw MathError("cannot decide of which polynomial a node is a root");
    }

    [[nodiscard]] Number horner(const RationalPolynomial& polynomial, const Ground& ground) const {
        Number result;
        for (long k = polynomial.degree(); k >= 0; --k) {
            result = result * value_ + ground.rational(polynomial.coefficient(k), "1");
        }
        return result;
    }

    Number value_;
    RationalPolynomial minimal_;
};

}  // namespace

std::optional<RationalPolynomial> as_polynomial(const ExactFunction& function) {
    if (!function.is_polynomial()) { return std::nullopt; }
    RationalPolynomial result;
    for (const ExactTerm& term : function.terms()) {
        const auto coefficient = rational_text(term.coefficient);
        if (!coefficient) { return std::nullopt; }
        result.set_coefficient(term.power, *coefficient);
    }
    return result;
}

std::optional<Interpolation> interpolate(const std::vector<RationalPolynomial>& psi,
                                         const RationalPolynomial& P, const NumberVector& nodes,
                                         const Ground& ground) {
    const auto u = columns(psi, P);
    if (!u) { return std::nullopt; }
    const RationalPolynomial beta = weight(*u, psi);
    const std::vector<IrreducibleFactor> factors = irreducible_factors(P);
    Interpolation result;
    for (const Number& node : nodes) {
        const Root root(node, factors);
        NumberVector row;
        for (const RationalPolynomial& column : *u) { row.push_back(root.at(column, ground)); }
        result.M_inverse.push_back(std::move(row));
        result.b.push_back(root.at(beta, ground));
    }
    return result;
}

}  // namespace hvi::gen
