// Strongly connected components: values that must be solved for together, and their order.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace hvi::gen {

/// The dependencies of vertices: needs[v] lists the vertices that v depends on.
using DependencyGraph = std::vector<std::vector<std::size_t>>;

/// Returns the components, each after those that it depends on; members ascend. The order is a
/// function of the graph alone.
[[nodiscard]] std::vector<std::vector<std::size_t>> components(const DependencyGraph& needs);

}  // namespace hvi::gen
