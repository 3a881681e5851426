// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/plan/costs.hpp"

#include <cmath>

namespace hvi::gen {

namespace {

/// Where an iteration waits for a sum over the stages, in additions.
constexpr double wait = 16;

/// Changes of corrections, component by component.
double judged(double unknowns) { return 8 * unknowns; }

/// How a correction goes, see ModeLanes of the runtime: slopes to the basis of modes and back, and
/// between them products of complex matrices in half as many lanes as there are stages.
double cost_of_correction(double stages, double unknowns) {
    const double to_and_from = 2 * stages * unknowns;
    const double inverse = 4 * unknowns * unknowns / 2;
    return to_and_from + inverse + judged(unknowns) + 3 * wait;
}

/// 0 where there is none.
double cost_of_linear_part(const LinearPart& linear, double stages, double unknowns) {
    if (std::holds_alternative<CoupledConstants>(linear)) {
        return cost_of_correction(stages, unknowns);
    }
    const auto* stiff = std::get_if<StiffComponents>(&linear);
    if (stiff == nullptr) { return 0; }
    const auto count = static_cast<double>(stiff->components.size());
    return count * (stages + 4) + judged(unknowns) + wait;
}

}  // namespace

/// NOTE: iterations of gauss:8 with a joint gradient, and with each slope used at once:
/// nonseparable, h = 0.35, 18.1 and 18.4; point-vortices, h = 0.1, 4.1 and 3.8; double-pendulum,
/// h = 0.1, 12.4 and 8.5. Where slopes are used at once, P moves between dH/dp and dH/dq but Q does
/// not move between dH/dq and the next dH/dp, so that what depends on q alone is shared; and the
/// sums of the stages are waited for twice, not once.
bool joint_gradient_pays(const EvaluationCosts& costs) {
    constexpr double more_iterations = 1.4;
    const double jointly = costs.joint + wait;
    const double in_turn = costs.by_q + costs.by_p_at_q + 2 * wait;
    return costs.joint > 0 && more_iterations * jointly < in_turn;
}

SolverCosts solver_costs(const Step& step, const SystemProperties& system) {
    const auto n = static_cast<double>(system.degrees_of_freedom);
    const auto s = static_cast<double>(step.positions.size());
    const bool has_momenta = std::holds_alternative<PairStep>(step.form);
    const bool is_joint = step.slopes == Slopes::joint;
    const double unknowns = has_momenta ? 2 * n : n;
    const EvaluationCosts& costs = system.costs;
    const double slopes = !has_momenta ? costs.by_q
                          : is_joint   ? costs.joint
                                       : costs.by_q + costs.by_p_at_q;
    // A sum of s products for each component, its change, and what is scaled.
    const double sweep = unknowns * (s + 8) + slopes + (has_momenta && !is_joint ? 2 * wait : wait);
    const double correction = sweep + cost_of_correction(s, unknowns);
    const double factors = costs.second + 4 * unknowns * unknowns * (unknowns + 4) / 2 + 3 * wait;
    const auto rounded = [](double cost) { return static_cast<int>(std::lround(cost)); };
    const double linear =
        !step.corrections ? 0 : cost_of_linear_part(step.corrections->linear, s, unknowns);
    const double with_linear = linear > 0 ? sweep + linear : 0;
    return {rounded(sweep), rounded(with_linear), rounded(correction), rounded(factors)};
}

}  // namespace hvi::gen
