// Parts of H whose flows are known in closed form.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "generator/expr/expression.hpp"
#include "generator/graph/graph.hpp"

namespace hvi::gen {

/// The change of a variable under the flow of a part, from values before the flow.
struct Moved {
    bool is_conjugate = false;
    std::size_t component = 0;  ///< among the numbers of all coordinates, or of all conjugates
    Scaled change;
};

/// Changes where some values are not negative: where rotations turn by a quarter at most, they need
/// no half turn.
struct UsualFlow {
    std::vector<Scaled> conditions;
    std::vector<Moved> moved;
};

/// A part of H, and its flow over the time HamiltonianParts::duration.
struct HamiltonianPart {
    std::string name;
    Expression expression;  ///< as it was written, or found
    std::string flow;       ///< in words: `kicks and drifts`
    std::vector<Moved> moved;
    std::optional<UsualFlow> usual;  ///< with fewer operations
    Scaled value = {};               ///< of the part
};

/// What stands for a part that is found and has more than two thousand words.
inline constexpr const char* too_long_part = "...";
[[nodiscard]] inline bool is_too_long(const HamiltonianPart& part) {
    return part.expression.kind == Expression::Kind::symbol &&
           part.expression.name == too_long_part;
}

/// Parts whose sum is H. The change of a part over the time h is exact.
struct HamiltonianParts {
    Node duration = 0;  ///< input of the graph with Role::parameter: the time of a flow
    std::vector<HamiltonianPart> parts;
};

}  // namespace hvi::gen
