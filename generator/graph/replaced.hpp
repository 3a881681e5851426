// Substitution of inputs in a value.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>

#include "generator/graph/graph.hpp"

namespace hvi::gen {

/// Substitutes `inputs` in `value`; new nodes go into the same graph. Precondition: no divisor
/// becomes 0.
[[nodiscard]] Scaled replaced(Graph& graph, const Scaled& value,
                              const std::map<Node, Scaled>& inputs);

}  // namespace hvi::gen
