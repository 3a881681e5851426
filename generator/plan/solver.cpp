// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/plan/solver.hpp"

#include <fmt/format.h>

namespace hvi::gen {

namespace {

/// C_ij = b_i n_ij of the positions that are solved for: see PositionEquations of the runtime.
NumberMatrix coupling(const Scheme& scheme) {
    NumberMatrix C;
    for (const Block& block : scheme.blocks) {
        if (!block.coupled) { continue; }
        const auto Q = block.of(StageNode::Kind::Q);
        for (const std::size_t i : Q) {
            NumberVector& row = C.emplace_back();
            for (const std::size_t j : Q) {
                row.push_back(scheme.positions[i].weight * scheme.velocity_form->n[i][j]);
            }
        }
    }
    return C;
}

void set_modes(Scheme& scheme) {
    constexpr std::size_t most = 32;  // enclosing eigenvalues takes the cube of it
    if (!scheme.velocity_form || !scheme.takes_newton()) { return; }
    const NumberMatrix C = coupling(scheme);
    if (C.size() <= most) { scheme.modes = real_modes(C); }
    if (!scheme.modes) { return; }
    const std::size_t pairs = scheme.modes->imaginary_parts.size();
    scheme.decisions.push_back(
        {fmt::format("the equations of Newton's method decouple: {} real eigenvalue{} of A A~ and "
                     "{} pair{}",
                     scheme.modes->real_ones, scheme.modes->real_ones == 1 ? "" : "s", pairs,
                     pairs == 1 ? "" : "s"),
         "at the start of a step all stages have the same second derivatives"});
}

/// Where both slopes of a stage are unknown, they may be evaluated at the same Q and P.
void set_joint_slopes(Scheme& scheme, bool joint_gradient_pays) {
    if (scheme.separable || !joint_gradient_pays) { return; }
    for (const Block& block : scheme.blocks) {
        if (block.of(StageNode::Kind::Lq) != block.of(StageNode::Kind::Lp)) { return; }
    }
    scheme.has_joint_slopes = true;
    scheme.decisions.push_back(
        {"dH/dq and dH/dp are evaluated together",
         "what they have in common is computed once, and neither waits for the other, by the count "
         "of operations for less than the iterations that this may add"});
}

}  // namespace

void set_solver(Scheme& scheme, Solver wished, bool joint_gradient_pays) {
    if (scheme.is_explicit()) { return; }
    scheme.solver = wished;
    if (scheme.solver == Solver::automatic) {
        scheme.decisions.push_back(
            {"fixed points, and Newton's method for steps on which they are slow",
             "how stiff H is depends on h and on the state"});
    }
    set_joint_slopes(scheme, joint_gradient_pays);
    set_modes(scheme);
}

}  // namespace hvi::gen
