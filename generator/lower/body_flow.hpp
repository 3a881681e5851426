// Flows of functions of the angular momentum of one body.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/lower/flow_changes.hpp"
#include "generator/lower/shears.hpp"

namespace hvi::gen {

/// A function of the variables of a body, row by row in R.
struct FunctionOfBody {
    Scaled function;
    std::vector<Node> R, L;
    std::vector<Scaled> by_turns, by_L;          ///< slopes, by turns about the axes of the body
    std::size_t first_of_R = 0, first_of_L = 0;  ///< components of q and p
};

/// Adds the motion of a body where it is known, and returns its kind; else nothing is added, and
/// the kind is empty. It is known where the function depends on one component of L, or on L_i^2 +
/// L_j^2 and L_k, which is proved.
[[nodiscard]] std::string add_body_flow(FlowChanges& changes, TurnAngles& angles,
                                        const FunctionOfBody& body);

}  // namespace hvi::gen
