// Identities sin^2 + cos^2 = 1 and cosh^2 - sinh^2 = 1 in sums.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/graph/graph.hpp"

namespace hvi::gen {

/// Replaces a sin(x)^2 + a cos(x)^2, and a cosh(x)^2 - a sinh(x)^2, by a. Returns whether there was
/// any. Precondition: no two terms have the same node.
[[nodiscard]] bool apply_pythagoras(Graph& graph, std::vector<Scaled>& terms);

}  // namespace hvi::gen
