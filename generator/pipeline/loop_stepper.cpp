// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/pipeline/loop_stepper.hpp"

#include <utility>

#include "generator/emit/steps/loops.hpp"
#include "generator/emit/text/names.hpp"
#include "generator/exact/methods/galerkin.hpp"
#include "generator/lower/loop_hessian.hpp"
#include "generator/lower/loop_system.hpp"
#include "generator/options/option_table.hpp"
#include "generator/plan/plan.hpp"

namespace hvi::gen {

namespace {

void check_wishes(const StepperWishes& wishes, const Place& place) {
    const auto refuse = [&](bool is_wished, const char* flag) {
        if (!is_wished) { return; }
        throw InputError(std::string(flag) + " is not built for more than 64 degrees of freedom",
                         place);
    };
    refuse(wishes.dense, "--dense");
    refuse(wishes.action, "--action");
    refuse(wishes.float128, "--float128");
    refuse(wishes.lanes.choice == Lanes::ensemble, "--lanes ensemble");
    refuse(wishes.lanes.choice == Lanes::stages, "--lanes stages");
    refuse(wishes.solver == Solver::newton_taylor, "--solver newton-taylor");
}

/// What the step that was planned would take and systems of any size do not have.
void check_step(const Step& step, const StepperWishes& wishes, const Method& method,
                const IndexedScene& scene) {
    if (step.from_parameter) {
        throw InputError("methods with a free parameter are not built for more than 64 degrees of "
                         "freedom",
                         method.place, "give it a value");
    }
    if (std::holds_alternative<GalerkinStep>(step.form)) {
        throw InputError("more nodes than functions are built for more than 64 degrees of freedom "
                         "where the kinetic energy is quadratic, and no steps are composed",
                         method.place, "take as many nodes as functions");
    }
    if (std::holds_alternative<PairStep>(step.form) && wishes.solver == Solver::newton) {
        throw InputError("--solver newton is built for more than 64 degrees of freedom where the "
                         "kinetic energy is quadratic, and no steps are composed",
                         whole(scene.function.source), "without it fixed points are iterated");
    }
}

/// NOTE: fixed points alone solve for pairs.
Step planned(const OneStepMethod& method, const SystemProperties& system,
             const StepperWishes& wishes) {
    Step step = plan(method, system, {.solver = wishes.solver});
    const bool is_of_pairs =
        std::holds_alternative<PairStep>(step.form) && step.iteration() != nullptr;
    return is_of_pairs ? plan(method, system, {.solver = Solver::fixed_point}) : step;
}

/// Where Newton's method may be called for.
std::optional<LoopHessian> hessian(LoopSystem& system, const Step& step) {
    const auto* velocities = std::get_if<VelocityStep>(&step.form);
    if (velocities == nullptr || !velocities->iteration.takes_newton()) { return std::nullopt; }
    return loop_hessian(system, velocities->hessian);
}

std::string command(const OneStepMethod& method, const IndexedScene& scene,
                    const StepperWishes& wishes) {
    return "hvi-gen stepper " + method.provenance().origin + " " + scene.origin +
           options_for(wishes);
}

}  // namespace

LoopStepper loop_stepper(const Method& wished, const IndexedScene& scene,
                         const StepperWishes& wishes) {
    check_wishes(wishes, whole(scene.function.source));
    check_own_names(scene.own);
    for (const NamedIndexed& invariant : scene.invariants) {
        check_function_name(invariant.name, invariant.place_of_name);
    }
    OneStepMethod method{derive_any(wished), wishes.composition, wished.place};
    if (wishes.composition) { check_composition(*wishes.composition, method.base); }
    LoopSystem system = loop_system(scene);
    std::optional<SiteSystem> sites = site_system(system);
    Step step = planned(method, properties(system, sites), wishes);
    check_step(step, wishes, wished, scene);
    const std::optional<LoopHessian> second = hessian(system, step);
    const std::string name =
        wishes.class_name ? wishes.class_name->text : class_name(scene.name + "-" + method.name());
    const bool is_swept = sites && std::holds_alternative<ExplicitStep>(step.form);
    const LoopCode code{system, sites, second, wishes.evaluations && !is_swept};
    std::string header =
        emit_loops(method, step, code,
                   {.class_name = name, .command = command(method, scene, wishes), .loops = &code});
    return {std::move(method), std::move(system), std::move(sites), std::move(step), name,
            std::move(header), scene.own.headers};
}

}  // namespace hvi::gen
