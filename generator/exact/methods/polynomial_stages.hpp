// Collocation at all the roots of a polynomial over Q, where sums over the stages are rational.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/exact/algebra/polynomial.hpp"
#include "generator/exact/methods/trees.hpp"
#include "generator/exact/numbers/verdict.hpp"

namespace hvi::gen {

/// The method of Algorithm 4.3 for a basis of the polynomials over Q of degree less than s, at the
/// roots c_1 .. c_s of P. A function on the stages is a polynomial g modulo P, with the values
/// g(c_i). With <g, h> = sum_i b_i g(c_i) h(c_i), the integral over [0,1] of g h modulo P,
///
///     b.g = <1, g>,    A g = integral_0^x g modulo P,    <A~ g, h> + <g, A h> = (b.g)(b.h).
///
/// Preconditions: P has no multiple root, and no weight is zero.
class PolynomialStages {
public:
    using Function = RationalPolynomial;
    using Scalar = RationalPolynomial;  ///< a constant

    explicit PolynomialStages(RationalPolynomial P);

    [[nodiscard]] long count() const { return P_.degree(); }

    [[nodiscard]] Function one() const { return RationalPolynomial(1); }
    [[nodiscard]] Function product(const Function& g, const Function& h) const;
    /// Returns `times` b.g - 1, for either colour.
    [[nodiscard]] Scalar defect(Colour colour, const Function& g, long times) const;
    /// Returns A g for f, A~ g for g, times a number.
    [[nodiscard]] Function apply(Colour colour, const Function& g, long times) const;
    /// Returns the projection onto the span of the basis, which has all functions on the stages.
    [[nodiscard]] static Function projected(const Function& g) { return g; }
    [[nodiscard]] Function power(long exponent) const;        ///< x^exponent
    [[nodiscard]] const Scalar& moment(long exponent) const;  ///< b.x^exponent

    struct Less {
        bool operator()(const Function& g, const Function& h) const {
            return fmpq_poly_cmp(g.get(), h.get()) < 0;
        }
    };

private:
    [[nodiscard]] Function integral(const Function& g) const;
    [[nodiscard]] Function partner_of_power(long k) const;

    RationalPolynomial P_;
    std::vector<RationalPolynomial> quotients_;  ///< D_m of (P(x) - P(y))/(x - y) = sum D_m(x) y^m
    RationalPolynomial scale_;                   ///< 1/(b_i P'(c_i)), as a function on the stages
    mutable std::vector<Function> partner_;      ///< A~ x^k as far as asked for
    mutable std::vector<Scalar> moments_;
    mutable Function last_power_{1};  ///< the one of the last moment
};

}  // namespace hvi::gen
