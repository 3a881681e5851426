// The values of a graph's nodes for values of its inputs.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <vector>

#include "generator/graph/graph.hpp"
#include "generator/scene/value_at.hpp"

namespace hvi::gen {

/// Enclosures of the values, which are not finite where there is no value. Precondition: the
/// inputs' balls are not exact, so that an exact zero is zero for all inputs.
class NodeBalls {
public:
    using Value = Ball;

    [[nodiscard]] static Ball integer(long value);
    [[nodiscard]] static Ball sum(const Ball& a, const Ball& b);
    [[nodiscard]] static Ball product(const Ball& a, const Ball& b);
    [[nodiscard]] static bool is_zero(const Ball& a);  ///< whether it is known
    /// Throws MathError where the matrix is not proved to be regular.
    [[nodiscard]] static std::vector<std::vector<Ball>>
    inverse(const std::vector<std::vector<Ball>>& matrix);

    /// The graph may grow, but for its inputs.
    NodeBalls(const Graph& graph, SymbolValues inputs)
        : graph_(graph), inputs_(std::move(inputs)) {}

    /// Throws MathError where there is no value.
    [[nodiscard]] Ball operator()(const Scaled& a);

private:
    [[nodiscard]] const Ball& at(Node node);
    [[nodiscard]] Ball computed(const Computation& computation);

    const Graph& graph_;
    SymbolValues inputs_;
    std::map<Node, Ball> known_;
};

}  // namespace hvi::gen
