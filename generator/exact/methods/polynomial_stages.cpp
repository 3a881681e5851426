// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/methods/polynomial_stages.hpp"

#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

RationalPolynomial over_unit_interval(const RationalPolynomial& g) {
    RationalPolynomial result;
    result.set_coefficient(0, g.integral_over_unit_interval());
    return result;
}

RationalPolynomial times(const RationalPolynomial& g, long numerator, long denominator) {
    RationalPolynomial result;
    fmpq_poly_scalar_mul_si(result.get(), g.get(), numerator);
    fmpq_poly_scalar_div_si(result.get(), result.get(), denominator);
    return result;
}

/// Returns the quotients of P and x^(m+1), m = 0 .. s-1.
std::vector<RationalPolynomial> quotients(const RationalPolynomial& P) {
    std::vector<RationalPolynomial> result;
    for (long m = 0; m < P.degree(); ++m) {
        RationalPolynomial D;
        fmpq_poly_shift_right(D.get(), P.get(), m + 1);
        result.push_back(std::move(D));
    }
    return result;
}

/// Returns 1/(sum_m D_m/(m+1)): phi_i = P/((x - c_i) P'(c_i)) = sum_m D_m(c_i) x^m / P'(c_i) has
/// the integral b_i.
RationalPolynomial inverse_weights(const std::vector<RationalPolynomial>& D,
                                   const RationalPolynomial& P) {
    RationalPolynomial sum;
    for (std::size_t m = 0; m < D.size(); ++m) {
        sum = sum + times(D[m], 1, static_cast<long>(m) + 1);
    }
    const auto result = inverse_modulo(sum, P);
    HVI_CHECK(result);
    return *result;
}

}  // namespace

PolynomialStages::PolynomialStages(RationalPolynomial P)
    : P_(std::move(P)), quotients_(quotients(P_)), scale_(inverse_weights(quotients_, P_)) {}

RationalPolynomial PolynomialStages::product(const Function& g, const Function& h) const {
    const RationalPolynomial result = g * h;
    return result.degree() < P_.degree() ? result : remainder(result, P_);
}

RationalPolynomial PolynomialStages::defect(Colour, const Function& g, long factor) const {
    return times(over_unit_interval(g), factor, 1) - RationalPolynomial(1);
}

RationalPolynomial PolynomialStages::apply(Colour colour, const Function& g, long factor) const {
    if (colour == Colour::f) { return times(integral(g), factor, 1); }
    RationalPolynomial result;
    for (long k = 0; k <= g.degree(); ++k) {
        if (g.coefficient(k) == "0") { continue; }
        while (static_cast<long>(partner_.size()) <= k) {
            partner_.push_back(partner_of_power(static_cast<long>(partner_.size())));
        }
        RationalPolynomial coefficient;
        coefficient.set_coefficient(0, g.coefficient(k));
        result = result + partner_[static_cast<std::size_t>(k)] * coefficient;
    }
    return times(result, factor, 1);
}

RationalPolynomial PolynomialStages::power(long exponent) const {
    RationalPolynomial result;
    result.set_coefficient(exponent, "1");
    return result.degree() < P_.degree() ? result : remainder(result, P_);
}

RationalPolynomial PolynomialStages::integral(const Function& g) const {
    const RationalPolynomial result = antiderivative(g);
    return result.degree() < P_.degree() ? result : remainder(result, P_);
}

const RationalPolynomial& PolynomialStages::moment(long exponent) const {
    while (static_cast<long>(moments_.size()) <= exponent) {
        if (!moments_.empty()) {
            last_power_ = product(last_power_, RationalPolynomial::variable());
        }
        moments_.push_back(over_unit_interval(last_power_));
    }
    return moments_[static_cast<std::size_t>(exponent)];
}

/// Returns A~ x^k. A~ g = b.g - (1/b_i) sum_j b_j a_ji g(c_j) in stage i, and a_ji is the integral
/// of phi_i from 0 to c_j: the sum is (1/P'(c_i)) sum_m D_m(c_i) b.(g x^(m+1))/(m+1).
RationalPolynomial PolynomialStages::partner_of_power(long k) const {
    RationalPolynomial sum;
    for (long m = 0; m < P_.degree(); ++m) {
        const RationalPolynomial factor = times(moment(k + m + 1), 1, m + 1);
        sum = sum + quotients_[static_cast<std::size_t>(m)] * factor;
    }
    return moment(k) - product(scale_, sum);
}

}  // namespace hvi::gen
