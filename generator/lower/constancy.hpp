// Values that do not depend on the variables, however they are written.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "generator/graph/graph.hpp"
#include "generator/scene/value_at.hpp"

namespace hvi::gen {

/// Returns the value for q = p = t = 0, in the same graph; empty where it divides by zero.
[[nodiscard]] std::optional<Scaled> at_origin(Graph& graph, const Scaled& a);

/// Returns a node of parameters and constants alone that has this value for all variables, where
/// there is one and that is proved: by the graph, or in a field in which variables and parameters
/// are free.
[[nodiscard]] std::optional<Scaled> constant_value(Graph& graph, const Scaled& a);

/// Returns whether one of the values depends on one of the nodes, as they are written.
[[nodiscard]] bool depend(const Graph& graph, const std::vector<Scaled>& values,
                          const std::vector<Node>& nodes);

/// Returns a - b.
[[nodiscard]] Scaled difference_of(Graph& graph, const Scaled& a, const Scaled& b);

/// Returns whether a value is 0 for all variables and parameters, and that is proved.
[[nodiscard]] bool is_proved_zero(const Graph& graph, const Scaled& a);

/// Returns a value for each input, all different; those of the variables differ for each `step`.
[[nodiscard]] SymbolValues sample_point(const Graph& graph, std::size_t step);

}  // namespace hvi::gen
