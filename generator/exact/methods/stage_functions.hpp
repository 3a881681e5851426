// Functions on the stages of a method, in coordinates.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/exact/methods/galerkin_rule.hpp"

namespace hvi::gen {

/// Operations of (4.18) on functions g on the stages, which have s coordinates in some basis. Sums
/// and products of these matrices that do not depend on the basis are the same as with the
/// tableau's own, whose coordinates are the values g(c_i).
struct StageFunctions {
    NumberMatrix A, A_tilde;
    NumberVector one;   ///< the function that is 1 on every stage
    NumberVector b;     ///< b.g = sum_i b_i g(c_i)
    NumberMatrix gram;  ///< g^T gram h = sum_i b_i g(c_i) h(c_i)
    /// For a rule: the part of A g outside of the span of its basis, A g - E A g for the projection
    /// E that is orthogonal for the rule. Empty where the span has all functions.
    NumberMatrix outside;

    [[nodiscard]] std::size_t count() const { return b.size(); }
};

/// Returns the functions of a tableau. The basis is 1, x, ..., x^(s-1) where there is a
/// `node_polynomial`: all is rational then, whatever the nodes are. Otherwise the values on the
/// stages are the coordinates.
[[nodiscard]] StageFunctions stage_functions(const Tableau& tableau);

/// Returns the functions of partitioned_method(rule); powers are the basis where it is
/// `over_rationals`.
[[nodiscard]] StageFunctions stage_functions(const GalerkinRule& rule);

/// Returns how many terms the normal forms of A and A~ have, which is the cost of arithmetic with
/// them.
[[nodiscard]] std::size_t term_count(const StageFunctions& stages);

}  // namespace hvi::gen
