// The general Galerkin form at all the roots of a polynomial over Q, where its sums are rational.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/exact/methods/polynomial_stages.hpp"
#include "generator/exact/methods/rational_rule.hpp"

namespace hvi::gen {

/// The method of partitioned_method(GalerkinRule). A function on the stages is a polynomial g
/// modulo P, with the values g(c_i). With <g, h> = sum_i b_i g(c_i) h(c_i)
///
///     b.g = <1, g>,    A g = integral_0^x v modulo P,    <A~ g, h> + <g, A h> = (b.g)(b.h),
///
/// where v is the projection of g onto the span: <v, psi_k> = <g, psi_k> for all k.
///
/// Preconditions: the rule is exact on the span, which has the constants; G is regular.
class ProjectedStages {
public:
    using Function = RationalPolynomial;
    using Scalar = RationalPolynomial;  ///< a constant
    using Less = PolynomialStages::Less;

    explicit ProjectedStages(const RationalRule& rule);

    [[nodiscard]] long count() const { return P_.degree(); }

    [[nodiscard]] Function one() const { return RationalPolynomial(1); }
    [[nodiscard]] Function product(const Function& g, const Function& h) const;
    /// Returns `times` b.g - 1, for either colour.
    [[nodiscard]] Scalar defect(Colour colour, const Function& g, long times) const;
    /// Returns A g for f, A~ g for g, times a number.
    [[nodiscard]] Function apply(Colour colour, const Function& g, long times) const;
    /// Returns v, modulo P.
    [[nodiscard]] Function projected(const Function& g) const;

    /// Returns the coefficients of x^k y^m in n(x, y) modulo P(x) and P(y): n_ij of GalerkinRule is
    /// n(c_i, c_j), and all n_ij are 0 where all coefficients are.
    [[nodiscard]] const RationalMatrix& positions() const { return n_; }

private:
    struct Factors;
    ProjectedStages(const RationalPolynomial& P, const Factors& factors);

    [[nodiscard]] Function applied(const RationalMatrix& matrix, const Function& g) const;

    RationalPolynomial P_;
    RationalMatrix A_, A_tilde_, projection_;  ///< act on rows of coefficients, from the right
    RationalMatrix n_;
};

}  // namespace hvi::gen
