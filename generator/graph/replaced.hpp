// A value with other inputs.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>

#include "generator/graph/graph.hpp"

namespace hvi::gen {

/// The value with other ones for some inputs, in the same graph. Precondition: it divides by
/// nothing that becomes 0.
[[nodiscard]] Scaled replaced(Graph& graph, const Scaled& value,
                              const std::map<Node, Scaled>& inputs);

}  // namespace hvi::gen
