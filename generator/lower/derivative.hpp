// Derivatives of a node of a graph, as nodes of the same graph.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/graph/graph.hpp"

namespace hvi::gen {

/// Returns the partial derivatives of f by these inputs, in reverse mode: from f down, each node
/// gets the derivative of f by it once (Griewank & Walther, Evaluating Derivatives, Section 3.2).
/// The derivatives share nodes of f, and cost a small multiple of f, however many inputs there are.
[[nodiscard]] std::vector<Scaled> gradient(Graph& graph, const Scaled& f,
                                           const std::vector<Node>& inputs);

}  // namespace hvi::gen
