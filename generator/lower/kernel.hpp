// Which nodes of a graph some results need, when each is computed, and what it costs.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/lower/graph.hpp"

namespace hvi::gen {

/// How often what is done. A factor of 1 or -1 costs nothing.
struct OperationCounts {
    std::size_t additions = 0;
    std::size_t multiplications = 0;
    std::size_t divisions = 0;
    std::size_t square_roots = 0;
    std::size_t calls = 0;  ///< of sin, exp, pow, ...

    friend bool operator==(const OperationCounts&, const OperationCounts&) = default;
};

/// Straight-line code: nodes in an order in which they can be computed.
struct Kernel {
    std::vector<Node> once;  ///< from parameters and constants: computed before all steps
    std::vector<Node> each;  ///< from variables: computed at every evaluation
    std::vector<Scaled> results;
    std::vector<std::size_t> uses;  ///< of each node of the graph, by other nodes and results
    OperationCounts per_evaluation;
};

/// What these results need, and nothing else.
[[nodiscard]] Kernel kernel(const Graph& graph, std::vector<Scaled> results);

}  // namespace hvi::gen
