// Substitution in values.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <vector>

#include "generator/graph/graph.hpp"

namespace hvi::gen {

/// Substitutes `inputs` in `value`; new nodes go into the same graph. Precondition: no divisor
/// becomes 0.
[[nodiscard]] Scaled replaced(Graph& graph, const Scaled& value,
                              const std::map<Node, Scaled>& inputs);

/// Writes nodes as others of the same value, also within those. Precondition: no node is written by
/// itself.
[[nodiscard]] std::vector<Scaled> rewritten(Graph& graph, std::vector<Scaled> values,
                                            const std::map<Node, Scaled>& forms);

}  // namespace hvi::gen
