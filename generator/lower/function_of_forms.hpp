// Functions of a quadratic form whose degrees of freedom do not couple.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "generator/lower/shears.hpp"

namespace hvi::gen {

/// A function f(Q) of Q = sum_k (a_k q_k^2 + 2 c_k q_k p_k + b_k p_k^2)/2.
struct FunctionOfForms {
    std::vector<PlaneForm> forms;  ///< of each degree of freedom: b_k is not zero, or a_k is not
    Scaled speed;                  ///< f'(Q) at the variables
};

/// Variables of some degrees of freedom, and the slopes of a function by them.
struct SlopesOfDegrees {
    std::vector<Node> q, p;
    std::vector<Scaled> by_q, by_p;
};

/// Returns the slopes of a form by q and by p.
[[nodiscard]] std::pair<Scaled, Scaled> slopes_of_form(Graph& graph, const PlaneForm& form, Node q,
                                                       Node p);

/// Returns f'(Q) for a Q that is given, where df/dz = f'(Q) dQ/dz for each variable is proved; else
/// nothing. Precondition: no form has a = b = 0, and one has b.
[[nodiscard]] std::optional<Scaled> speed_of_forms(Graph& graph, const Scaled& function,
                                                   const std::vector<PlaneForm>& forms,
                                                   const SlopesOfDegrees& slopes);

/// Finds Q and f'(Q) of a function of which the slopes are given, which is proved: df/dz = f'(Q)
/// dQ/dz for each variable. Returns nothing where no Q is found; it is looked for among values that
/// stand in the graph of the function.
[[nodiscard]] std::optional<FunctionOfForms> function_of_forms(Graph& graph, const Scaled& function,
                                                               const SlopesOfDegrees& slopes);

}  // namespace hvi::gen
