// Derivatives of events along the motion, where sums are written out for events alone.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "generator/lower/lowered_events.hpp"

namespace hvi::gen {

/// Returns, by the number of each node, whether the values depend on it; the nodes of the values
/// are included.
[[nodiscard]] std::vector<bool> nodes_of(const Graph& graph, const std::vector<Scaled>& values);

/// Returns {g, H} + dg/dt in the graph of the events, which has g and H. The conjugate of the
/// coordinate with number k is the variable k + degrees. H is differentiated only by the few
/// variables whose partners g depends on.
[[nodiscard]] Scaled slope_along(LoweredEvents& events, const Scaled& g, const Scaled& hamiltonian,
                                 std::size_t degrees);

}  // namespace hvi::gen
