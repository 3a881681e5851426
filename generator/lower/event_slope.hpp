// Derivatives of events along the motion, where sums are written out for events alone.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "generator/lower/lowered_events.hpp"

namespace hvi::gen {

/// The nodes that values are made of, themselves among them: by their numbers, whether one is.
[[nodiscard]] std::vector<bool> nodes_of(const Graph& graph, const std::vector<Scaled>& values);

/// {g, H} + dg/dt in the graph of the events, which has g and H. The conjugate of the coordinate
/// with the number k is the variable k + degrees. H is differentiated by the few variables alone
/// whose partners g looks at.
[[nodiscard]] Scaled slope_along(LoweredEvents& events, const Scaled& g, const Scaled& hamiltonian,
                                 std::size_t degrees);

}  // namespace hvi::gen
