// The gradient of a quadratic Hamiltonian on the stages of a method.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/exact/methods/stage_functions.hpp"
#include "generator/exact/numbers/ground.hpp"
#include "generator/linear/quadratic_form.hpp"

namespace hvi::gen {

/// The stages x = (Q, P) of (4.18) and the gradient K = (W, V) = (dH/dq, dH/dp) on them satisfy
///
///     Q = q 1 + h A V,    P = p 1 + h C W,    K = S x + g 1,
///
/// with C = -A~ when (q, p) is the step's beginning, and C = 1 b^T - A~ when it is (q_0, p_1). So
///
///     K = (I - h (S (x) I) L)^-1 ((S (q, p) + g) (x) 1),    L = (0 A; C 0),
///
/// where variable i on stage (or with coordinate) a stands in place i s + a. For a rule (4.6d)
/// gives the projection of P - p onto its span, and (4.6e) the rest: dH/dp is in the span, so that
/// with the blocks pp and pq of S
///
///     P = p 1 + h C W - h (pp^-1 pq (x) F) V,    L = (0 A; C -pp^-1 pq (x) F),
///
/// where F = `outside` of StageFunctions.
struct StageGradients {
    NumberMatrix L;  ///< 2ns x 2ns
    /// The numerators of K = sum_k numerator[k] h^k / sum_k denominator[k] h^k (S (q, p) + g)
    std::vector<NumberMatrix> numerator;  ///< 2ns x 2n
    NumberVector denominator;             ///< det(I - h (S (x) I) L), 1 at h = 0

    /// Returns sum_k weights numerator[k] h^k.
    [[nodiscard]] NumberMatrix weighted(const NumberMatrix& weights, const Number& h) const;
};

/// Returns the gradients. Throws MathError when this would take minutes; for a rule TooLarge when
/// it would take seconds, and MathError where d2H/dp2 is singular.
[[nodiscard]] StageGradients stage_gradients(const NumberMatrix& S, const StageFunctions& stages,
                                             const NumberMatrix& C);

/// Returns the functions of a method whose map is asked for. Throws MathError when one that is
/// needed, or one of H, has no closed form.
[[nodiscard]] StageFunctions exact_stage_functions(const Tableau& tableau, const QuadraticForm& H);
[[nodiscard]] StageFunctions exact_stage_functions(const GalerkinRule& rule,
                                                   const QuadraticForm& H);

/// Return the 2n x 2n matrix (0 I; 0 0), with which x = (q, p) goes to (p, 0), and its transpose.
[[nodiscard]] NumberMatrix lower_half_up(std::size_t n);
[[nodiscard]] NumberMatrix upper_half_down(std::size_t n);

/// Returns sum_k coefficients[k] h^k. Precondition: there is at least one coefficient.
template <class Value>
[[nodiscard]] Value polynomial(const std::vector<Value>& coefficients, const Number& h) {
    Value result = coefficients.back();
    for (std::size_t k = coefficients.size() - 1; k-- > 0;) {
        result = result * h + coefficients[k];
    }
    return result;
}

}  // namespace hvi::gen
