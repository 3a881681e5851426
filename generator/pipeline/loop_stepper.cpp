// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/pipeline/loop_stepper.hpp"

#include <utility>

#include "generator/emit/steps/loops.hpp"
#include "generator/emit/text/names.hpp"
#include "generator/exact/methods/galerkin.hpp"
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
    refuse(wishes.solver == Solver::newton, "--solver newton");
    refuse(wishes.solver == Solver::newton_taylor, "--solver newton-taylor");
}

DerivedMethod derived(const Method& wished) {
    DerivedMethod method = derive_any(wished);
    if (std::holds_alternative<GalerkinRule>(method)) {
        throw InputError("methods with more nodes than functions are not built for more than 64 "
                         "degrees of freedom",
                         wished.place, "with as many functions as nodes they are");
    }
    return method;
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
    for (const NamedIndexed& invariant : scene.invariants) {
        check_function_name(invariant.name, invariant.place_of_name);
    }
    OneStepMethod method{derived(wished), wishes.composition, wished.place};
    if (wishes.composition) { check_composition(*wishes.composition, method.base); }
    LoopSystem system = loop_system(scene);
    std::optional<SiteSystem> sites = site_system(system);
    Step step = plan(method, {.is_separable = system.is_separable()});
    if (step.from_parameter) {
        throw InputError("methods with a free parameter are not built for more than 64 degrees of "
                         "freedom",
                         wished.place, "give it a value");
    }
    const std::string name =
        wishes.class_name ? wishes.class_name->text : class_name(scene.name + "-" + method.name());
    const bool is_swept = sites && std::holds_alternative<ExplicitStep>(step.form);
    const LoopCode code{system, sites, wishes.evaluations && !is_swept};
    std::string header =
        emit_loops(method, step, code,
                   {.class_name = name, .command = command(method, scene, wishes), .loops = &code});
    return {std::move(method), std::move(system), std::move(sites), std::move(step), name,
            std::move(header)};
}

}  // namespace hvi::gen
