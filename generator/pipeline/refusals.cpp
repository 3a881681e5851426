// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/pipeline/refusals.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "generator/expr/functions.hpp"
#include "generator/expr/own_functions.hpp"
#include "generator/lower/kernel.hpp"
#include "generator/plan/lanes.hpp"
#include "generator/read/no_loops.hpp"

namespace hvi::gen {

namespace {

void check_solver(const Step& step, const StepperWishes& wishes, const Place& place) {
    const Iteration* iteration = step.iteration();
    if (iteration == nullptr || std::holds_alternative<VelocityStep>(step.form)) return;
    if (iteration->solver != Solver::newton_taylor) return;
    if (wishes.action)
        throw InputError("--solver newton-taylor solves for positions alone, and --action needs "
                         "the momenta of the stages",
                         place, "--solver newton goes with it");
    throw InputError("--solver newton-taylor is built only for H = T(p) + U(q) with a "
                     "quadratic T",
                     place, "--solver newton takes any H");
}

/// Refuses counted sweeps where there are none.
void check_sweeps(const Step& step, const StepperWishes& wishes) {
    if (wishes.sweeps.choice == 0) return;
    const std::string obstacle = obstacle_to_sweeps(step);
    if (!obstacle.empty())
        throw InputError("--sweeps does not go with this method on this H: " + obstacle,
                         wishes.sweeps.place, "leave it out");
    if (wishes.action)
        throw InputError("--action does not go with --sweeps, whose steps are symplectic up to "
                         "the last change alone and have no generating function",
                         wishes.sweeps.place);
}

void check_lanes(const Step& step, const StepperWishes& wishes) {
    const Wish<Lanes>& wished = wishes.lanes;
    if (wished.choice != Lanes::stages) return;
    if (wishes.action)
        throw InputError("--action is not built for stages side by side: it is summed over one "
                         "stage after the other",
                         wished.place, "without --lanes it takes them so");
    const std::string obstacle = obstacle_to_stage_lanes(step);
    if (obstacle.empty()) return;
    throw InputError("no lanes for the stages of this method on this H: " + obstacle, wished.place,
                     "without --lanes they are used where they can be");
}

/// Refuses wishes that are not built for an ensemble.
void check_ensemble(const Step& step, const StepperWishes& wishes) {
    if (wishes.lanes.choice != Lanes::ensemble) return;
    const std::optional<Place>& place = wishes.lanes.place;
    const auto refuse = [&](bool is_wished, const char* flag, const char* reason) {
        if (is_wished)
            throw InputError(std::string(flag) + " is not built for ensembles: " + reason, place,
                             "without --lanes ensemble there is a stepper of one trajectory");
    };
    refuse(wishes.dense, "--dense", "trajectories take all their steps at once");
    refuse(wishes.action, "--action", "trajectories take all their steps at once");
    refuse(wishes.float128, "--float128", "no processor computes several of these at once");
    refuse(wishes.evaluations, "--evaluations", "one evaluation serves several trajectories");
    const std::string obstacle = obstacle_to_ensemble(step);
    if (!obstacle.empty())
        throw InputError("no ensembles of this method on this H: " + obstacle, place,
                         "they are built for explicit methods, as stormer-verlet and its "
                         "compositions are where H = T(p) + U(q), for splittings as strang, and "
                         "for midpoint and gauss:S");
}

/// Refuses wishes that are not built where a trajectory is a thread of a GPU.
void check_threads(const Step& step, const StepperWishes& wishes) {
    if (wishes.lanes.choice != Lanes::gpu) return;
    const std::optional<Place>& place = wishes.lanes.place;
    const auto refuse = [&](bool is_wished, const char* flag, const char* reason) {
        if (is_wished)
            throw InputError(std::string(flag) + " is not built for --lanes gpu: " + reason, place,
                             "without --lanes gpu there is a stepper of one trajectory");
    };
    refuse(wishes.dense, "--dense", "trajectories take all their steps at once");
    refuse(wishes.action, "--action", "trajectories take all their steps at once");
    refuse(wishes.float128, "--float128", "a GPU computes in float or double");
    refuse(wishes.evaluations, "--evaluations", "threads count nothing together");
    const std::string obstacle = obstacle_to_threads(step);
    if (!obstacle.empty())
        throw InputError("no --lanes gpu for this method on this H: " + obstacle, place,
                         "it is built for explicit methods, as stormer-verlet and its "
                         "compositions are where H = T(p) + U(q), and for midpoint and gauss:S");
}

/// Returns the values that a header computes on a device.
std::vector<Scaled> values_on_device(const System& system, const StepperWishes& wishes) {
    std::vector<Scaled> values = by_coordinates(system);
    const auto add = [&](const std::vector<Scaled>& more) {
        values.insert(values.end(), more.begin(), more.end());
    };
    add(by_conjugates(system));
    add(start_of(system));
    if (wishes.energy) { values.push_back(energy_of(system)); }
    if (wishes.invariants) {
        for (const SystemValue& invariant : system.invariants) {
            values.push_back(value_of(invariant));
        }
    }
    return values;
}

/// Returns whether a device has the function. NOTE: what src/hvi/detail/device/math.hpp has.
bool is_on_device(const Computation& computation) {
    constexpr std::string_view smooth[] = {"exp", "log",  "sin",  "cos",
                                           "tan", "sinh", "cosh", "tanh"};
    if (computation.operation == Operation::power) return false;
    if (computation.operation != Operation::call) return true;
    if (is_own_function(computation.name)) return false;
    return !is_smooth(computation.name) ||
           std::count(std::begin(smooth), std::end(smooth), computation.name) > 0;
}

/// Returns whether its equations are solved by Eigen's factors of sparse matrices.
bool has_sparse_factors(const Step& step) {
    const auto* velocities = std::get_if<VelocityStep>(&step.form);
    return velocities != nullptr && velocities->iteration.takes_newton() &&
           velocities->hessian == HessianForm::sparse;
}

/// Refuses steps that vectors of any size do not have.
void check_vectors(const Step& step, const Method& method, const StepperWishes& wishes,
                   const Place& place) {
    if (wishes.float128 && has_sparse_factors(step)) {
        throw NoLoops("--float128 does not go with factors of sparse matrices, which Eigen "
                      "computes in the numbers of C++",
                      place,
                      "--solver fixed-point needs none, where h is small against all periods; or "
                      "write sums out: --unroll yes");
    }
    if (std::holds_alternative<GalerkinStep>(step.form)) {
        throw NoLoops("more nodes than functions are built where sums stay loops for a quadratic "
                      "kinetic energy alone, and no steps are composed",
                      method.place,
                      "take as many nodes as functions, or write sums out: --unroll yes");
    }
}

}  // namespace

std::string obstacle_to_sweeps(const Step& step) {
    if (std::holds_alternative<TabulatedStep>(step.form)) {
        return "nothing is iterated, as a step is one linear map";
    }
    if (step.iteration() == nullptr) { return "nothing is iterated, as the step is explicit"; }
    if (std::holds_alternative<ChartStep>(step.form)) { return "it is not built for rotations"; }
    if (std::holds_alternative<GalerkinStep>(step.form)) {
        return "it is not built for steps that are solved for the velocities of a curve";
    }
    return "";
}

void check_newton(const System& system, const Step& step, const Place& place) {
    const Iteration* iteration = step.iteration();
    const bool takes_newton = iteration != nullptr && iteration->takes_newton();
    if (!takes_newton || system.structure.hessian != HessianForm::none) return;
    if (rotations_of(system) > 0)
        throw NoLoops("--solver newton is not built for rotations where sums stay loops", place,
                      "without it fixed points are iterated; or write sums out: --unroll yes");
    throw NoLoops("--solver newton is not built where sums stay loops and stand in products or "
                  "functions, which couple all with all",
                  place, "without it fixed points are iterated; or write sums out: --unroll yes");
}

void check_functions_on_device(const System& system, const StepperWishes& wishes) {
    if (wishes.lanes.choice != Lanes::gpu) return;
    const Kernel all = kernel_of_inputs(system.graph, values_on_device(system, wishes));
    for (const Node node : all.nodes) {
        const Computation& computation = system.graph.at(node);
        if (is_on_device(computation)) continue;
        const bool is_power = computation.operation == Operation::power;
        const std::string what =
            is_power ? "a power with such an exponent" : "the function `" + computation.name + "`";
        throw InputError("--lanes gpu has not " + what, wishes.lanes.place,
                         "there are sqrt, exp, log, sin, cos, tan, sinh, cosh, tanh, abs, sign, "
                         "min, max, if, and powers with whole exponents and halves");
    }
}

std::string wish_without_loops(const StepperWishes& wishes) {
    const std::pair<bool, const char*> all[] = {
        {wishes.lanes.choice == Lanes::ensemble, "--lanes ensemble"},
        {wishes.lanes.choice == Lanes::gpu, "--lanes gpu"},
        {wishes.lanes.choice == Lanes::stages, "--lanes stages"},
        {wishes.solver == Solver::newton_taylor, "--solver newton-taylor"},
    };
    for (const auto& [is_wished, option] : all)
        if (is_wished) return option;
    return "";
}

void check_wishes_of_any_size(const StepperWishes& wishes, const Place& place) {
    const std::string option = wish_without_loops(wishes);
    if (!option.empty())
        throw InputError(option + " is not built where sums stay loops", place,
                         "write sums out: --unroll yes");
}

void check_splitting(const System& system, const Method& method, const StepperWishes& wishes,
                     const Place& place) {
    if (!system.is_written_out())
        throw NoLoops("flows of parts of H are not built where sums stay loops", place,
                      "write sums out: --unroll yes; or let H be T(p) + U(q), without [split]");
    if (system.side == Side::lagrangian)
        throw MathError("a splitting takes a Hamiltonian", method.place,
                        "`hvi-gen scheme` prints that of this Lagrangian");
    const auto refuse = [&](bool is_wished, const std::string& what) {
        if (is_wished)
            throw InputError(what + " is not built for flows of parts of H", method.place,
                             "take a method that is no splitting: gauss:2");
    };
    refuse(system.scaled.has_value(), "scaled time");
    refuse(wishes.action, "--action");
}

void check_step(const Step& step, const Method& method, const StepperWishes& wishes,
                const Place& place) {
    check_sweeps(step, wishes);
    if (step.container == Container::vectors) {
        check_vectors(step, method, wishes, place);
        return;
    }
    check_solver(step, wishes, place);
    check_lanes(step, wishes);
    check_ensemble(step, wishes);
    check_threads(step, wishes);
}

}  // namespace hvi::gen
