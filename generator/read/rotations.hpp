// Rotations of a scene: their names, and how their values are written.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/expr/expression.hpp"

namespace hvi::gen {

/// A rotation R of a body, from body to space, and its angular momentum L in the body: `R` and `L`,
/// or `R[2]` and `L[2]`. The entries of both are among the variables.
struct RotationNames {
    std::string rotation;
    std::string momentum;
};

/// Returns R[1,1], R[1,2], ..., R[3,3], or R[2,1,1], ...
[[nodiscard]] std::vector<std::string> entries_of(const std::string& rotation);

/// Returns L[1], L[2], L[3], or L[2,1], ...
[[nodiscard]] std::vector<std::string> components_of(const std::string& momentum);

// The nine entries of a rotation, row by row.

[[nodiscard]] std::vector<Expression> identity_rotation();

/// Returns the turn by an angle about an axis of any length but 0. Precondition: the axis has three
/// components.
[[nodiscard]] std::vector<Expression> turn_about(const std::vector<Expression>& axis,
                                                 const Expression& angle);

/// Returns the turn of a quaternion w, x, y, z of any length but 0. Precondition: `wxyz` has four
/// entries.
[[nodiscard]] std::vector<Expression> turn_of_quaternion(const std::vector<Expression>& wxyz);

}  // namespace hvi::gen
