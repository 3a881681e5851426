// Parts of H whose flows are known in closed form.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "generator/expr/expression.hpp"
#include "generator/expr/small_steps.hpp"
#include "generator/graph/graph.hpp"

namespace hvi::gen {

/// The change of a variable under the flow of a part, from values before the flow.
struct Moved {
    bool is_conjugate = false;
    std::size_t component = 0;  ///< among the numbers of all coordinates, or of all conjugates
    Scaled change;
};

/// Functions of the runtime that compute values in each flow.
enum class RuntimeFunction {
    orbits,               ///< of bodies about each other: orbit_values()
    turn_about_momentum,  ///< of a body
};

/// Values that the runtime computes for one orbit: f - 1, g - tau, f' and g' - 1.
inline constexpr std::size_t changes_of_orbit = 4;

/// Values that a function of the runtime computes in each flow, an array from an array.
struct RuntimeValues {
    RuntimeFunction function;
    std::vector<Scaled> given;
    std::vector<Node> results;  ///< inputs of the graph
};

/// Changes where some values are not negative: rotations by small angles need no half turn, and
/// have faster functions.
struct UsualFlow {
    std::vector<Scaled> conditions;
    std::vector<Moved> moved;
};

/// The flow of a quadratic form z^T S z/2 + l^T z of degrees of freedom that it couples, z = (q,
/// p), as a matrix: the runtime computes that when the time changes, and the changes from it.
struct FormMoved {
    std::vector<std::size_t> degrees;  ///< components of q and of p
    std::vector<Scaled> rows;          ///< of (S l), each from the diagonal on
};

/// A part of H, and its flow over the time HamiltonianParts::duration.
struct HamiltonianPart {
    std::string name;
    Expression expression;  ///< as it was written, or found
    std::string flow;       ///< in words: `kicks and drifts`
    std::vector<Moved> moved;
    std::optional<UsualFlow> usual;                ///< with fewer operations
    std::vector<RuntimeValues> in_each_flow = {};  ///< that the changes are computed from
    std::vector<FormMoved> forms = {};
    Scaled value = {};                     ///< of the part
    std::string text = {};                 ///< that tells more than a long expression; may be empty
    std::vector<Expression> made_of = {};  ///< functions that it is a function of; may be empty
};

/// Text in place of a part that is found and has more than two thousand words.
inline constexpr const char* too_long_part = "...";
[[nodiscard]] inline bool is_too_long(const HamiltonianPart& part) {
    return part.expression.kind == Expression::Kind::symbol &&
           part.expression.name == too_long_part;
}

/// Returns what users are shown of a part.
[[nodiscard]] inline std::string text_of(const HamiltonianPart& part) {
    return part.text.empty() ? to_text(part.expression) : part.text;
}

/// Parts whose sum is H. The change of a part over the time h is exact.
struct HamiltonianParts {
    Node duration = 0;  ///< input of the graph with Role::parameter: the time of a flow
    std::vector<HamiltonianPart> parts;
    SmallSteps small_steps = {};
    /// Part with whose flow the time goes on, where H depends on it. This part does not depend on
    /// it, and in all other flows the time stands still.
    std::optional<std::size_t> clock = {};
};

/// Returns whether a part moves by the matrix of a quadratic form.
[[nodiscard]] bool moves_forms(const HamiltonianParts& parts);
/// Returns whether the flow of a part needs a function of the runtime.
[[nodiscard]] bool calls(const HamiltonianParts& parts, RuntimeFunction function);

}  // namespace hvi::gen
