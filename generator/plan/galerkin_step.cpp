// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/plan/galerkin_step.hpp"

#include <fmt/format.h>

#include "generator/plan/starting_values.hpp"

namespace hvi::gen {
namespace {

void note_unused_nodes(Step& step, const OneStepMethod& method) {
    const auto* rule = std::get_if<GalerkinRule>(&method.base);
    if (rule == nullptr) { return; }
    for (std::size_t i = 0; i < rule->nodes(); ++i) {
        if (rule->b[i].known_zero() != true) { continue; }
        step.decisions.push_back(
            {fmt::format("Q_{} is not computed", i + 1), "its weight is zero"});
    }
}

/// Makes one block of all unknowns.
void set_stages(Step& step, const GalerkinForm& form) {
    Block all{true, {}};
    for (const StageNode::Kind kind :
         {StageNode::Kind::Q, StageNode::Kind::P, StageNode::Kind::Lq, StageNode::Kind::Lp}) {
        for (std::size_t i = 0; i < form.nodes(); ++i) { all.nodes.push_back({kind, i}); }
    }
    step.blocks = {std::move(all)};
    for (std::size_t i = 0; i < form.nodes(); ++i) {
        step.positions.push_back({StageValue::Place::inner, {i}, form.b[i]});
    }
    step.m.resize(form.nodes());
}

/// Returns the reason why no momenta are eliminated.
std::string why_both(const SystemProperties& system, const StepWishes& wishes) {
    if (!system.kinetic_is_quadratic) {
        return "d2H/dp2 is not seen to be constant, so that neither can be eliminated";
    }
    if (wishes.action) { return "the action is summed over both"; }
    return "the steps of a composition are taken one after the other, and those of a Nystrom "
           "method are not built so";
}

Decision what_is_solved_for(const SystemProperties& system, const StepWishes& wishes) {
    if (system.side == Side::lagrangian) {
        return {"the velocities of the curve are solved for",
                "(4.14) has p = dL/dv on it, and no mass matrix is inverted in a formula"};
    }
    return {"the velocities of the curve and the momenta at the nodes are solved for",
            why_both(system, wishes)};
}

}  // namespace

NumberVector steps_in_a_row(const OneStepMethod& method) {
    return method.composition ? method.composition->steps : NumberVector{};
}

void note_composition(Step& step, const OneStepMethod& method) {
    if (!method.composition) { return; }
    step.decisions.push_back({fmt::format("{} steps in a row", method.composition->steps.size()),
                              fmt::format("they make a method of order {}: {}",
                                          method.composition->order, method.composition->name)});
}

void set_nodes(Step& step, const OneStepMethod& method, const GalerkinForm& form) {
    note_unused_nodes(step, method);
    set_stages(step, form);
}

void set_galerkin(Step& step, const OneStepMethod& method, const SystemProperties& system,
                  const StepWishes& wishes) {
    GalerkinStep galerkin;
    galerkin.side = system.side;
    galerkin.form = galerkin_form(method.base);
    step.in_a_row = steps_in_a_row(method);
    galerkin.has_adjoint = method.composition && method.composition->with_adjoint &&
                           !is_symmetric(galerkin.form).holds;
    set_nodes(step, method, galerkin.form);
    step.slopes = system.is_separable ? Slopes::of_parts : Slopes::joint;
    step.partner = Partner::different;
    step.decisions.push_back(what_is_solved_for(system, wishes));
    note_composition(step, method);
    step.decisions.push_back(
        {"the basis is orthogonal for the rule",
         fmt::format("any basis of the span makes the same step, and with this one an iteration "
                     "needs no matrix larger than {}",
                     system.side == Side::hamiltonian ? "d2H/dp2" : "d2L/dv2")});
    set_extrapolation(step, galerkin);
    step.form = std::move(galerkin);
}

}  // namespace hvi::gen
