// Strongly connected components: what must be solved for at once, and in which order.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace hvi::gen {

/// needs[v] lists what v depends on.
using DependencyGraph = std::vector<std::vector<std::size_t>>;

/// The components, each after all that it depends on; members ascend. The order is a function of
/// the graph alone.
[[nodiscard]] std::vector<std::vector<std::size_t>> components(const DependencyGraph& needs);

}  // namespace hvi::gen
