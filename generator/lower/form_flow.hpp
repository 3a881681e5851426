// Quadratic forms of several degrees of freedom.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "generator/graph/graph.hpp"

namespace hvi::gen {

/// Degrees of freedom that a form may couple: its matrix has no zeros, so that work grows with the
/// square of their number, and with the cube where the time changes.
inline constexpr std::size_t most_coupled = 8;

/// Returns the rows of (S l), each from the diagonal on, where the slopes by these variables z are
/// S z + l with values that do not vary, which is proved; else nothing.
///
/// NOTE: the flow is a matrix, as three shears do not make it: each has a symmetric block, and so
/// has their product where it takes p to q; that of a charge in a magnetic field has not.
[[nodiscard]] std::optional<std::vector<Scaled>>
rows_of_form(Graph& graph, const std::vector<Scaled>& slopes, const std::vector<Node>& variables);

}  // namespace hvi::gen
