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

/// Result of the conditions of one family of trees.
struct OrderConditions {
    int order = 0;             ///< all trees with at most so many vertices are integrated exactly
    bool is_at_least = false;  ///< nothing failed up to the largest order asked for
    bool proved = true;        ///< no condition rests on enclosures of zero (see verdict.hpp)
    std::vector<std::int64_t> conditions;  ///< numbers of checked conditions of order 1, 2, ...

    /// Failures of order `order` + 1, sorted by tree. All of them for trees of up to
    /// `most_listed_vertices`; beyond, one for each value of gamma sum_i b_i Phi_i.
    std::vector<FailedCondition> failures;
    static constexpr int most_listed_vertices = 9;

    /// The sum over all failures of (residual/sigma)^2: the square of the norm of the coefficients
    /// of the elementary differentials in the local error's first term (Hairer, Norsett & Wanner,
    /// Solving Ordinary Differential Equations I, Section II.3: (1 - gamma Phi) alpha / (order+1)!
    /// with alpha = (order+1)!/(sigma gamma)). Empty where not all failures are listed, and with a
    /// free parameter: nobody reads a sum of squares of so many terms.
    std::optional<Number> error_constant_squared;

    /// Returns the root of that sum; exact where the square is rational.
    [[nodiscard]] std::optional<Number> error_constant() const;
};

struct Orders {
    OrderConditions general, separable, nystrom;
};

/// Checks the conditions of order 1, 2, ..., `max_order` until some fail, in exact arithmetic where
/// the numbers allow it, and over Q where the tableau has a `node_polynomial`, at whatever nodes.
/// Where trees of so many vertices have hundreds of thousands of elementary weights that are not
/// known to be equal, it stops below `max_order`. With free parameters the order is the generic
/// one. Precondition: 1 <= max_order <= most_vertices. Throws MathError where a residual cannot be
/// told from zero.
[[nodiscard]] Orders orders(const Tableau& tableau, int max_order);

/// Checks the conditions by the coefficients alone.
[[nodiscard]] Orders orders(const PartitionedMethod& method, int max_order);

/// Checks the conditions of the general Galerkin form, for a quadratic kinetic energy. Over Q,
/// whatever the nodes are, where the rule is `over_rationals`.
[[nodiscard]] OrderConditions nystrom_order(const GalerkinRule& rule, int max_order);

/// Returns the largest orders whose conditions can each hold, for some of the numbers that the
/// coefficients can be. Failures are proved; their residuals are those of the written coefficients.
[[nodiscard]] Orders orders(const RoundedMethod& method, int max_order);

}  // namespace hvi::gen
