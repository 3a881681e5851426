// Nodes that results need, the order of their computation, and its cost.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/graph/graph.hpp"

namespace hvi::gen {

/// Numbers of operations. A factor of 1 or -1 costs nothing.
struct OperationCounts {
    std::size_t additions = 0;
    std::size_t multiplications = 0;
    std::size_t divisions = 0;
    std::size_t square_roots = 0;
    std::size_t calls = 0;  ///< of sin, exp, pow, ...

    OperationCounts& operator+=(const OperationCounts& more);
    friend bool operator==(const OperationCounts&, const OperationCounts&) = default;
};

/// Costs in additions, approximately.
inline constexpr double cost_of_division = 8, cost_of_root = 8, cost_of_call = 24;
[[nodiscard]] double cost(const OperationCounts& counts);

/// Straight-line code: nodes in an order in which they can be computed from given ones.
struct Kernel {
    std::vector<Node> given;  ///< nodes that the code uses and does not compute, ascending
    std::vector<Node> nodes;  ///< each as soon as a result needs it
    std::vector<Scaled> results;
    std::vector<std::size_t> uses;  ///< uses of each node of the graph, by these nodes and results
    /// Nodes that are 1/b and used once, ascending: they have no value of their own, and in a
    /// product with a are the division a/b.
    std::vector<Node> divisors;
    OperationCounts counts;  ///< operations of nodes and results

    [[nodiscard]] bool is_divisor(Node node) const;
};

/// Returns the code of every evaluation. Given are the variables and all values that do not depend
/// on them: constants, parameters and values of these alone.
[[nodiscard]] Kernel kernel(const Graph& graph, std::vector<Scaled> results);

/// Returns code that runs once, from inputs and constants.
[[nodiscard]] Kernel kernel_of_inputs(const Graph& graph, std::vector<Scaled> results);

/// Returns the code of each direction. Given are all values that do not depend on it.
[[nodiscard]] Kernel kernel_of_direction(const Graph& graph, std::vector<Scaled> results);

/// Returns the code of each p at the same q and t. Given are all values that do not depend on p.
[[nodiscard]] Kernel kernel_of_momenta(const Graph& graph, std::vector<Scaled> results);

}  // namespace hvi::gen
