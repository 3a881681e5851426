// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/plan/costs.hpp"

#include <cmath>

namespace hvi::gen {

namespace {

/// Cost of waiting for a sum over the stages, in operations.
constexpr double wait = 16;

/// Returns how many registers so many numbers side by side take. NOTE: registers of four, on every
/// machine, as costs decide how a step is solved.
double registers(double lanes) { return std::ceil(lanes / 4); }

/// Returns the cost of judging the changes of corrections, component by component.
double judged(double stages, double unknowns) { return 8 * unknowns * registers(stages); }

/// Returns the cost of a correction, see ModeLanes of the runtime: slopes go to the basis of modes
/// and back, and between them are products of complex matrices in half as many lanes as there are
/// stages.
double cost_of_correction(double stages, double unknowns) {
    const double to_and_from = 2 * stages * unknowns * registers(stages);
    const double inverse = 4 * unknowns * unknowns * registers(stages / 2);
    return to_and_from + inverse + judged(stages, unknowns) + 4 * wait;
}

/// Returns the cost of the linear part; 0 where there is none.
double cost_of_linear_part(const LinearPart& linear, double stages, double unknowns) {
    if (std::holds_alternative<CoupledConstants>(linear)) {
        return cost_of_correction(stages, unknowns);
    }
    const auto* stiff = std::get_if<StiffComponents>(&linear);
    if (stiff == nullptr) { return 0; }
    const auto count = static_cast<double>(stiff->components.size());
    return count * (stages + 4) * registers(stages) + judged(stages, unknowns) + wait;
}

double unknowns_of(const Step& step, const SystemProperties& system) {
    const auto n = static_cast<double>(system.degrees_of_freedom);
    return std::holds_alternative<PairStep>(step.form) ? 2 * n : n;
}

double cost_of_slopes(const Step& step, const EvaluationCosts& costs) {
    if (!std::holds_alternative<PairStep>(step.form)) { return costs.by_q; }
    return step.slopes == Slopes::joint ? costs.joint : costs.by_q + costs.by_p_at_q;
}

}  // namespace

/// NOTE: iterations of gauss:8 with a joint gradient, and with each slope used at once:
/// nonseparable, h = 0.35, 18.1 and 18.4; point-vortices, h = 0.1, 4.1 and 3.8; double-pendulum, h
/// = 0.1, 12.4 and 8.5. Where slopes are used at once, P moves between dH/dp and dH/dq, but Q does
/// not move between dH/dq and the next dH/dp. So values that depend on q alone are shared. And an
/// iteration waits for the sums of the stages twice, not once.
bool joint_gradient_pays(const EvaluationCosts& costs) {
    constexpr double more_iterations = 1.4;
    const double jointly = costs.joint + wait;
    const double in_turn = costs.by_q + costs.by_p_at_q + 2 * wait;
    return costs.joint > 0 && more_iterations * jointly < in_turn;
}

double operations_of_a_sweep(const Step& step, const SystemProperties& system) {
    // A sum of s products for each component, its change, and scaling.
    const auto s = static_cast<double>(step.positions.size());
    return unknowns_of(step, system) * (s + 8) + cost_of_slopes(step, system.costs);
}

/// NOTE: measured with AVX2, for gauss:4, 8 and 16: a correction took 3.3, 3.5 and 3.5 sweeps on
/// nonseparable (here 3.4, 2.9, 2.8), 3.5, 2.8 and 2.9 on FPU (3.6, 2.9, 2.9), 3.6, 3.0 and 3.0 on
/// point-vortices (2.9, 2.4, 2.5), 1.6, 1.7 and 2.0 on double-pendulum (1.9, 1.7, 1.9). Factors
/// took 4.0, 2.4 and 1.5 sweeps on nonseparable (5.3, 2.7, 1.1), 18, 9 and 4 on FPU (26, 11, 4),
/// 20, 12 and 6 on point-vortices (28, 13, 5), 3.4, 2.2 and 1.4 on double-pendulum (5.7, 2.8, 1.3).
SolverCosts solver_costs(const Step& step, const SystemProperties& system) {
    const auto s = static_cast<double>(step.positions.size());
    const double unknowns = unknowns_of(step, system);
    const bool waits_twice =
        std::holds_alternative<PairStep>(step.form) && step.slopes != Slopes::joint;
    const double sweep =
        registers(s) * operations_of_a_sweep(step, system) + (waits_twice ? 2 * wait : wait);
    const double correction = sweep + cost_of_correction(s, unknowns);
    // Row by row and number by number: loads and stores take longer than the operations on them.
    const double factors =
        system.costs.second + 8 * unknowns * unknowns * (unknowns + 4) + 3 * wait;
    const auto rounded = [](double cost) { return static_cast<int>(std::lround(cost)); };
    const double linear =
        !step.corrections ? 0 : cost_of_linear_part(step.corrections->linear, s, unknowns);
    const double with_linear = linear > 0 ? sweep + linear : 0;
    return {rounded(sweep), rounded(with_linear), rounded(correction), rounded(factors)};
}

}  // namespace hvi::gen
