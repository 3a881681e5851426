// Which nodes of a graph some results need, when each is computed, and what it costs.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/graph/graph.hpp"

namespace hvi::gen {

/// How often what is done. A factor of 1 or -1 costs nothing.
struct OperationCounts {
    std::size_t additions = 0;
    std::size_t multiplications = 0;
    std::size_t divisions = 0;
    std::size_t square_roots = 0;
    std::size_t calls = 0;  ///< of sin, exp, pow, ...

    OperationCounts& operator+=(const OperationCounts& more);
    friend bool operator==(const OperationCounts&, const OperationCounts&) = default;
};

/// Straight-line code: nodes in an order in which they can be computed from what is given.
struct Kernel {
    std::vector<Node> given;  ///< what the nodes and results use and do not compute, ascending
    std::vector<Node> nodes;  ///< each as soon as a result is on its way that needs it
    std::vector<Scaled> results;
    std::vector<std::size_t> uses;  ///< of each node of the graph, by these nodes and results
    /// Of the nodes those that are 1/b and used once, ascending: they have no value of their own,
    /// and in a product with a are the division a/b.
    std::vector<Node> divisors;
    OperationCounts counts;  ///< of nodes and results

    [[nodiscard]] bool is_divisor(Node node) const;
};

/// What is computed at every evaluation. Given are the variables, and what does not depend on them:
/// constants, parameters and what is made of these alone.
[[nodiscard]] Kernel kernel(const Graph& graph, std::vector<Scaled> results);

/// What is computed once, from inputs and constants.
[[nodiscard]] Kernel kernel_of_inputs(const Graph& graph, std::vector<Scaled> results);

/// What is computed for each direction. Given is all that does not depend on it.
[[nodiscard]] Kernel kernel_of_direction(const Graph& graph, std::vector<Scaled> results);

/// What is computed for each p at the same q and t. Given is all that does not depend on p.
[[nodiscard]] Kernel kernel_of_momenta(const Graph& graph, std::vector<Scaled> results);

}  // namespace hvi::gen
