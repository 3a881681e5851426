// Functions on the stages of a method, in coordinates.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/exact/methods/galerkin_rule.hpp"

namespace hvi::gen {

/// What (4.18) does with functions g on the stages, which have s coordinates in some basis. Sums
/// and products of these matrices that do not depend on the basis are the same as with the
/// tableau's own, for which a coordinate is a value g(c_i).
struct StageFunctions {
    NumberMatrix A, A_tilde;
    NumberVector one;   ///< the function that is 1 on every stage
    NumberVector b;     ///< b.g = sum_i b_i g(c_i)
    NumberMatrix gram;  ///< g^T gram h = sum_i b_i g(c_i) h(c_i)
    /// Of a rule: what A g has outside of the span of its basis, A g - E A g for the projection E
    /// that is orthogonal for the rule. Empty where the span is all functions.
    NumberMatrix outside;

    [[nodiscard]] std::size_t count() const { return b.size(); }
};

/// The basis is 1, x, ..., x^(s-1) where there is a `node_polynomial`: all is rational then,
/// whatever the nodes are. Else the values on the stages are the coordinates.
[[nodiscard]] StageFunctions stage_functions(const Tableau& tableau);

/// Those of partitioned_method(rule); powers are the basis where it is `over_rationals`.
[[nodiscard]] StageFunctions stage_functions(const GalerkinRule& rule);

/// How many terms the normal forms of A and A~ have, as what arithmetic with them costs.
[[nodiscard]] std::size_t term_count(const StageFunctions& stages);

}  // namespace hvi::gen
