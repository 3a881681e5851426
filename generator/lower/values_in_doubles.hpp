// Values of a graph in doubles, for decisions that need no proof.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "generator/graph/graph.hpp"

namespace hvi::gen {

/// Values of inputs by their names.
using InputValues = std::map<std::string, double>;

/// Returns the values of results, not finite where they have none. Precondition: each input that
/// they need has a value.
[[nodiscard]] std::vector<double> values_at(const Graph& graph, const std::vector<Scaled>& results,
                                            const InputValues& inputs);

}  // namespace hvi::gen
