// Flows of Hamiltonians that are known in closed form.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <variant>

#include "generator/ir/system.hpp"
#include "generator/lower/flow.hpp"

namespace hvi::gen {

/// The reason why no flow was found.
struct NoFlow {
    std::string reason;
};

/// Finds the flow of a function of the variables over a time, an input of the graph. The function
/// falls apart where degrees of freedom do not couple; each of these parts is one of
///
/// - a function of variables that it does not move: kicks, drifts, torques, which are shears;
/// - a quadratic form of one degree of freedom: a rotation, or hyperbolic, as three shears;
/// - a quadratic form of several degrees, with linear terms or without: a matrix;
/// - a function f(Q) of a sum Q of forms of one degree each: the flow of Q with the speed f'(Q), as
/// Q is conserved;
/// - a function of one component of the angular momentum of a body: a turn about its axis;
/// - a kinetic energy and attractions -k/r of relative motions that do not couple: Kepler orbits.
///
/// Shears are symplectic however their coefficients are rounded, and matrices have twice the
/// digits. The time stands still, and where a function depends on it only shears are known. Each
/// property is proved by exact algebra. Precondition: the system is written out.
[[nodiscard]] std::variant<Flow, NoFlow> flow_of(System& system, const Scaled& function,
                                                 Node duration);

}  // namespace hvi::gen
