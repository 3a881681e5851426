// The order of a partitioned Runge-Kutta method, by the conditions of bicoloured rooted trees.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "generator/exact/methods/galerkin_rule.hpp"
#include "generator/exact/methods/number_stages.hpp"
#include "generator/exact/methods/trees.hpp"

namespace hvi::gen {

/// A tree whose condition is violated, and sum_i b_i Phi_i - 1/gamma (b~ for a root g).
struct FailedCondition {
    TreePointer tree;
    Number residual;
};

/// What the conditions of one family of trees say.
struct OrderConditions {
    int order = 0;             ///< all trees up to so many vertices are integrated exactly
    bool is_at_least = false;  ///< nothing failed up to the largest order asked for
    bool proved = true;        ///< no condition rests on enclosures of zero (see verdict.hpp)
    std::vector<std::int64_t> conditions;  ///< how many there are of order 1, 2, ..., as looked at

    /// Of order `order` + 1, sorted by tree. All of them for trees of up to
    /// `most_listed_vertices`; beyond, one for each value of gamma sum_i b_i Phi_i.
    std::vector<FailedCondition> failures;
    static constexpr int most_listed_vertices = 9;

    /// The sum over all failures of (residual/sigma)^2: the square of the norm of the coefficients
    /// of the elementary differentials in the local error's first term (Hairer, Norsett & Wanner,
    /// Solving Ordinary Differential Equations I, Section II.3: (1 - gamma Phi) alpha / (order+1)!
    /// with alpha = (order+1)!/(sigma gamma)). Empty where not all failures are listed, and with a
    /// free parameter: nobody reads a sum of squares of so many terms.
    std::optional<Number> error_constant_squared;

    /// Its root; exact where the square is rational.
    [[nodiscard]] std::optional<Number> error_constant() const;
};

struct Orders {
    OrderConditions general, separable, nystrom;
};

/// Looks at the conditions of order 1, 2, ..., `max_order` until some fail. In exact arithmetic
/// where the numbers allow; over Q where the tableau has a `node_polynomial`, at whatever nodes.
/// Where trees of so many vertices have elementary weights that are not known to be equal, in
/// hundreds of thousands, it stops below `max_order`. With free parameters the order is the generic
/// one. Precondition: 1 <= max_order <= most_vertices. Throws MathError where a residual cannot be
/// told from zero.
[[nodiscard]] Orders orders(const Tableau& tableau, int max_order);

/// By the coefficients alone.
[[nodiscard]] Orders orders(const PartitionedMethod& method, int max_order);

/// Those of the general Galerkin form, for a quadratic kinetic energy. Over Q, whatever the nodes
/// are, where the rule is `over_rationals`.
[[nodiscard]] OrderConditions nystrom_order(const GalerkinRule& rule, int max_order);

/// The largest orders of which each condition by itself can hold, for some of the numbers that the
/// coefficients can be. Failures are proved; their residuals are those of the coefficients as
/// written.
[[nodiscard]] Orders orders(const RoundedMethod& method, int max_order);

}  // namespace hvi::gen
