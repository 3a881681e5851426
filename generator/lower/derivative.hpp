// Derivatives of a node of a graph, as nodes of the same graph.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/graph/graph.hpp"

namespace hvi::gen {

/// How the derivative by a node is handed down to what the node is made of. In terms, where it is a
/// short polynomial, like terms come together: y^2/2 - y^3/3 has y (1/2 - y/3) - y^2/3. As a whole,
/// the velocity p - b y of (p - b y)^2 is seen in both derivatives.
enum class Shares { in_terms, whole };

/// Returns the partial derivatives of f by these inputs, in reverse mode: from f down, each node
/// gets the derivative of f by it once (Griewank & Walther, Evaluating Derivatives, Section 3.2).
/// The derivatives share nodes of f, and cost a small multiple of f, however many inputs there are.
[[nodiscard]] std::vector<Scaled> gradient(Graph& graph, const Scaled& f,
                                           const std::vector<Node>& inputs,
                                           Shares shares = Shares::in_terms);

}  // namespace hvi::gen
