// Polynomials in few operations.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/graph/graph.hpp"

namespace hvi::gen {

/// Returns the values, with sums and products that are polynomials in other nodes collected and in
/// Horner's form where that takes fewer operations for all of them together. Values that H shares
/// stay shared, and what depends on q alone stays apart from p and from directions. The operations
/// of the result are never more than those of the values.
[[nodiscard]] std::vector<Scaled> collected(Graph& graph, const std::vector<Scaled>& values);

/// Returns the partial derivatives of f by these inputs, collected.
[[nodiscard]] std::vector<Scaled> short_gradient(Graph& graph, const Scaled& f,
                                                 const std::vector<Node>& inputs);

}  // namespace hvi::gen
