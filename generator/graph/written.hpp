// Expressions from a graph.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "generator/expr/expression.hpp"
#include "generator/graph/graph.hpp"

namespace hvi::gen {

[[nodiscard]] Expression as_expression(const SmallFraction& fraction);

/// Returns the operation as an expression of the values of its terms, factors included, or of its
/// arguments. Precondition: it is neither a constant nor an input.
[[nodiscard]] Expression of_operation(const Computation& computation,
                                      std::vector<Expression> values);

/// Returns the value as an expression of the inputs, without places. Empty where it has more than
/// two thousand words: a text repeats what a graph shares.
[[nodiscard]] std::optional<Expression> written(const Graph& graph, const Scaled& a);

}  // namespace hvi::gen
