// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/plan/solver.hpp"

#include <fmt/format.h>

#include <utility>

#include "generator/plan/costs.hpp"

namespace hvi::gen {

namespace {

constexpr std::size_t most_of_modes = 32;  // enclosing eigenvalues costs its cube

/// Returns C_ij = b_i n_ij of the positions that are solved for: see PositionEquations of the
/// runtime.
NumberMatrix coupling(const Step& step, const VelocityForm& form) {
    NumberMatrix C;
    for (const Block& block : step.blocks) {
        if (!block.coupled) { continue; }
        const auto Q = block.of(StageNode::Kind::Q);
        for (const std::size_t i : Q) {
            NumberVector& row = C.emplace_back();
            for (const std::size_t j : Q) {
                row.push_back(step.positions[i].weight * form.n[i][j]);
            }
        }
    }
    return C;
}

void set_modes(Step& step) {
    auto* velocities = std::get_if<VelocityStep>(&step.form);
    if (velocities == nullptr || !velocities->iteration.takes_newton()) { return; }
    const NumberMatrix C = coupling(step, velocities->form);
    if (C.size() <= most_of_modes) { velocities->modes = real_modes(C); }
    if (!velocities->modes) { return; }
    const RealModes& modes = *velocities->modes;
    const std::size_t pairs = modes.imaginary_parts.size();
    step.decisions.push_back(
        {fmt::format("the equations of Newton's method decouple: {} real eigenvalue{} of A A~ and "
                     "{} pair{}",
                     modes.real_ones, modes.real_ones == 1 ? "" : "s", pairs,
                     pairs == 1 ? "" : "s"),
         "at the start of a step all stages have the same second derivatives"});
}

bool has_factors(HessianForm hessian) {
    return hessian == HessianForm::band || hessian == HessianForm::sparse;
}

/// Sets the form of Newton's method for many degrees of freedom. NOTE: it has factors in the basis
/// of modes alone.
void set_hessian(Step& step, HessianForm hessian) {
    auto* velocities = std::get_if<VelocityStep>(&step.form);
    if (velocities == nullptr || !velocities->iteration.takes_newton()) { return; }
    velocities->hessian = hessian;
    if (has_factors(hessian) && !velocities->modes) {
        velocities->hessian = HessianForm::products;
        step.decisions.push_back({"Newton's method goes by products of second derivatives",
                                  "the stages do not decouple, and are too many to factor"});
    }
}

/// Returns the solver. NOTE: where the equations are linear, one correction solves them, with
/// factors that are kept as long as h is.
Solver solver_of(const Step& step, Solver wished, const SystemProperties& system) {
    if (wished == Solver::automatic && system.hessian == HessianForm::none) {
        return Solver::fixed_point;
    }
    const bool is_linear = system.has_linear_map && has_factors(system.hessian) &&
                           std::holds_alternative<VelocityStep>(step.form);
    return wished == Solver::automatic && is_linear ? Solver::newton : wished;
}

/// Sets joint slopes: where both slopes of a stage are unknown, they may be evaluated at the same Q
/// and P.
void set_joint_slopes(Step& step, const EvaluationCosts& costs) {
    if (step.slopes != Slopes::one_by_one || !joint_gradient_pays(costs)) { return; }
    for (const Block& block : step.blocks) {
        if (block.of(StageNode::Kind::Lq) != block.of(StageNode::Kind::Lp)) { return; }
    }
    step.slopes = Slopes::joint;
    step.decisions.push_back(
        {"dH/dq and dH/dp are evaluated together",
         "what they have in common is computed once, and neither waits for the other, by the count "
         "of operations for less than the iterations that this may add"});
}

/// Returns C_ij = b_i m_ij. Precondition: no stages are merged.
NumberMatrix coupling(const Step& step) {
    NumberMatrix C = step.m;
    for (std::size_t i = 0; i < C.size(); ++i) {
        for (Number& entry : C[i]) { entry = step.positions[i].weight * entry; }
    }
    return C;
}

/// Returns the modes for corrections: those of Newton's method for positions, which then finds them
/// with the corrections, or similar ones for pairs.
std::optional<RealModes> modes_of_lanes(Step& step) {
    if (auto* velocities = std::get_if<VelocityStep>(&step.form)) {
        return std::exchange(velocities->modes, std::nullopt);
    }
    const bool is_runge_kutta = step.partner == Partner::same && step.m.size() <= most_of_modes;
    return is_runge_kutta ? real_modes(coupling(step)) : std::nullopt;
}

/// Returns the linear part. Components by themselves are solved for where there are positions
/// alone.
LinearPart linear_part(const Step& step, const SystemProperties& system) {
    const bool is_by_components = std::holds_alternative<StiffComponents>(system.linear);
    const bool has_momenta = std::holds_alternative<PairStep>(step.form);
    return is_by_components && has_momenta ? LinearPart{} : system.linear;
}

std::string why_linear(std::monostate) { return {}; }
std::string why_linear(const StiffComponents& stiff) {
    const std::size_t count = stiff.components.size();
    return fmt::format("{} component{} constant stiffness", count,
                       count == 1 ? " has a" : "s have a");
}
std::string why_linear(CoupledConstants) {
    return "second derivatives of coupled components have constant terms";
}

}  // namespace

Iteration* iteration_of(Step& step) {
    if (auto* velocities = std::get_if<VelocityStep>(&step.form)) { return &velocities->iteration; }
    if (auto* galerkin = std::get_if<GalerkinStep>(&step.form)) { return &galerkin->iteration; }
    if (auto* charts = std::get_if<ChartStep>(&step.form)) { return &charts->iteration; }
    auto* pairs = std::get_if<PairStep>(&step.form);
    return pairs != nullptr && pairs->iteration ? &*pairs->iteration : nullptr;
}

void set_solver(Step& step, Solver wished, int sweeps, const SystemProperties& system) {
    Iteration* iteration = iteration_of(step);
    if (iteration == nullptr) { return; }
    iteration->solver = solver_of(step, wished, system);
    if (iteration->solver == Solver::newton && wished != Solver::newton) {
        step.decisions.push_back({"Newton's method, which keeps its factors while h stays",
                                  "H is quadratic: the equations are linear"});
    }
    if (iteration->counts_sweeps()) {
        iteration->sweeps = sweeps;
        step.decisions.push_back(
            {fmt::format("explicit: exactly {} sweep{} of fixed points, and a last evaluation",
                         sweeps, sweeps == 1 ? "" : "s"),
             "so many are asked for; the step is symplectic up to the last change alone"});
    }
    if (iteration->solver == Solver::automatic) {
        step.decisions.push_back(
            {"fixed points, and Newton's method for steps on which they are slow",
             "how stiff H is depends on h and on the state"});
    }
    set_joint_slopes(step, system.costs);
    set_modes(step);
    set_hessian(step, system.hessian);
}

void set_corrections(Step& step, const SystemProperties& system) {
    if (step.layout != Layout::stages || step.iteration()->solver != Solver::automatic) { return; }
    std::optional<RealModes> modes = modes_of_lanes(step);
    if (!modes) { return; }
    step.corrections = StageCorrections{std::move(*modes), linear_part(step, system)};
    step.corrections->costs = solver_costs(step, system);
    step.decisions.push_back(
        {"slopes are corrected with one Hessian for all stages where that costs less than sweeps",
         "in the basis of eigenvectors of A the stages decouple, and are corrected side by side"});
    if (exists(step.corrections->linear)) {
        step.decisions.push_back(
            {"of steps that are not small the linear part of dH is solved exactly in each sweep",
             std::visit([](const auto& part) { return why_linear(part); },
                        step.corrections->linear)});
    }
}

}  // namespace hvi::gen
