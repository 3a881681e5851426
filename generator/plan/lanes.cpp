// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/plan/lanes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/plan/costs.hpp"

namespace hvi::gen {

namespace {

constexpr auto of_curves = "the velocities of the curve are solved for";
constexpr auto of_charts = "charts of rotations are built for one trajectory alone";
constexpr auto of_clocks = "flows beside a time are built for one trajectory alone";

/// Returns whether all values are solved for. NOTE: two equal stages are one, and have another
/// weight in Q than in P.
bool all_are_solved_for(const std::vector<StageValue>& values) {
    return std::all_of(values.begin(), values.end(), [](const StageValue& value) {
        return value.place == StageValue::Place::inner && value.stages.size() == 1;
    });
}

/// Returns the reason why the stages cannot all be the unknowns of one iteration.
std::string obstacle_in_stages(const Step& step) {
    if (step.blocks.size() > 1) { return "the stages are not solved for all at once"; }
    const bool are_unknowns =
        all_are_solved_for(step.positions) && all_are_solved_for(step.momenta);
    return are_unknowns ? "" : "some stages are equal, or the state itself";
}

/// Returns the reason why trajectories cannot be computed side by side, whatever the solver is.
std::string obstacle_in_form(const Step& step) {
    if (step.from_parameter) { return "the coefficients depend on a parameter"; }
    if (std::holds_alternative<ExplicitStep>(step.form)) { return ""; }
    if (const auto* flows = std::get_if<FlowStep>(&step.form)) {
        return flows->clock ? of_clocks : "";
    }
    if (step.iteration() == nullptr) { return "they have no curve"; }
    if (std::holds_alternative<GalerkinStep>(step.form)) { return of_curves; }
    if (std::holds_alternative<ChartStep>(step.form)) { return of_charts; }
    return obstacle_in_stages(step);
}

/// Returns whether steps of eight trajectories would differ from those of one. NOTE: counted sweeps
/// end at a distance from the solution that depends on where they begin, and eight remember the
/// slopes of one step alone.
bool differs_side_by_side(const Iteration& iteration) {
    return iteration.counts_sweeps() && !iteration.extrapolation.empty() &&
           iteration.extrapolation.front().before.has_value();
}

/// Returns whether iterations wait for operands more than they compute.
///
/// NOTE: measured with AVX-512, gauss:8, registers of 4 against those of 8: Kepler 0.76 of the
/// time, Henon-Heiles 0.88, nonseparable 0.94, point vortices 0.98, FPU 1.09, pendulum 1.07, double
/// pendulum 1.3, outer solar system 1.07. One register of 8 is later than two of 4, one after the
/// other, in sums, quotients and square roots. Where there is much to compute, or a function of
/// many sums and products, two of 4 take twice as many instructions.
bool waits_for_sums(const Step& step, const SystemProperties& system) {
    constexpr std::size_t wide = 4;
    constexpr double little = 80;
    if (step.positions.size() <= wide || system.costs.has_calls) { return false; }
    if (std::holds_alternative<ChartStep>(step.form)) { return false; }
    return system.degrees_of_freedom > 0 && operations_of_a_sweep(step, system) < little;
}

}  // namespace

std::string obstacle_to_stage_lanes(const Step& step) {
    if (std::holds_alternative<TabulatedStep>(step.form)) { return "a step is one linear map"; }
    if (step.is_explicit()) { return "each stage of an explicit method needs the one before"; }
    if (step.from_parameter) { return "the coefficients depend on a parameter"; }
    if (std::holds_alternative<GalerkinStep>(step.form)) { return of_curves; }
    const Iteration& iteration = *step.iteration();
    if (!iteration.only_sweeps() && iteration.solver != Solver::automatic) {
        return "they are built for fixed points, and for these and Newton's method in turn";
    }
    if (step.positions.size() == 1) { return "there is one stage"; }
    // NOTE: in a chart all stages are solved for, also the one where the step begins. Steps of a
    // top with two stages take 0.66 of the time that they take one by one, and 0.73 with SSE2
    // alone; with eight stages 0.21 with AVX-512.
    return std::holds_alternative<ChartStep>(step.form) ? "" : obstacle_in_stages(step);
}

std::string obstacle_to_ensemble(const Step& step) {
    const Iteration* iteration = step.iteration();
    if (iteration != nullptr && !iteration->only_sweeps()) {
        return "they are iterated by fixed points";
    }
    return obstacle_in_form(step);
}

bool may_go_side_by_side(const Step& step) {
    const Iteration* iteration = step.iteration();
    const bool is_open = iteration == nullptr || iteration->solver == Solver::automatic ||
                         (iteration->only_sweeps() && !differs_side_by_side(*iteration));
    return is_open && obstacle_in_form(step).empty();
}

std::string obstacle_to_threads(const Step& step) {
    if (std::holds_alternative<FlowStep>(step.form)) { return "flows of parts are to come"; }
    if (std::holds_alternative<VelocityStep>(step.form)) {
        return "it is solved for positions alone";
    }
    if (step.iteration() != nullptr && step.iteration()->counts_sweeps()) {
        return "its sweeps end at round-off, and are not counted";
    }
    return obstacle_to_ensemble(step);
}

void set_lanes(Step& step, Lanes wished, const SystemProperties& system) {
    if (system.container == Container::vectors) {
        if (!std::holds_alternative<VelocityStep>(step.form)) { return; }
        step.layout = Layout::components;
        step.decisions.push_back(
            {"the components of vectors are computed side by side", "there are many of them"});
        return;
    }
    if (wished == Lanes::ensemble && obstacle_to_ensemble(step).empty()) {
        step.layout = Layout::trajectories;
        step.decisions.push_back(
            {"eight trajectories are computed side by side",
             fmt::format("one {}, in vectors of the processor, serves them all",
                         std::holds_alternative<FlowStep>(step.form) ? "flow of a part"
                                                                     : "evaluation of dH/dq")});
    }
    if (wished == Lanes::gpu && obstacle_to_threads(step).empty()) {
        step.layout = Layout::threads;
        step.decisions.push_back(
            {"a trajectory is a thread of a GPU, or a turn of a loop on the host",
             "scalar code without branches fills a GPU by itself"});
    }
    if (wished == Lanes::ensemble || wished == Lanes::gpu || wished == Lanes::none ||
        !obstacle_to_stage_lanes(step).empty()) {
        return;
    }
    step.layout = Layout::stages;
    step.decisions.push_back(
        {"the stages are computed side by side",
         fmt::format("one evaluation of dH/dq, in vectors of the processor, serves all {}",
                     step.positions.size())});
    if (step.slopes == Slopes::one_by_one && system.shared_slopes > 0) {
        step.shared_slopes = system.shared_slopes;
        step.decisions.push_back(
            {fmt::format("dH/dp takes {} value{} from the dH/dq before it", step.shared_slopes,
                         step.shared_slopes == 1 ? "" : "s"),
             "they depend on q alone, which has not moved"});
    }
    if (waits_for_sums(step, system)) {
        step.register_width = 4;
        step.decisions.push_back({"in registers of 4 at most",
                                  "what is computed is little, and what they wait for comes later "
                                  "in those of 8"});
    }
}

}  // namespace hvi::gen
