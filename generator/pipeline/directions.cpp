// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/pipeline/directions.hpp"

#include "generator/emit/steps/tangent.hpp"
#include "generator/exact/methods/composed_method.hpp"
#include "generator/pipeline/passes.hpp"

namespace hvi::gen {

namespace {

StepToEmit to_emit(const SceneStepper& stepper) {
    return {stepper.method,
            stepper.step,
            {.class_name = stepper.class_name,
             .command = stepper.command,
             .system = &stepper.system,
             .wishes = stepper.members,
             .evaluations = stepper.evaluations ? &*stepper.evaluations : nullptr}};
}

/// Wishes for the stepper of directions: explicit steps are taken for eight side by side.
///
/// NOTE: where stages are solved for, these are side by side already. Measured with AVX-512 and
/// gauss:4, in steps a direction, eight side by side and one by one: Kepler 1.1 and 1.4, outer
/// solar system 3.6 and 1.4.
StepperWishes wishes_of_carrier(const SceneStepper& stepper, const StepperWishes& wishes) {
    StepperWishes result;
    result.solver = wishes.solver;
    result.unroll = wishes.unroll;
    result.composition = wishes.composition;
    result.float128 = wishes.float128;
    const bool takes_several = stepper.step.container == Container::arrays && !wishes.float128 &&
                               wishes.lanes.choice != Lanes::none &&
                               std::holds_alternative<ExplicitStep>(stepper.step.form);
    result.lanes = {takes_several ? Lanes::ensemble : wishes.lanes.choice};
    return result;
}

}  // namespace

void add_directions(SceneStepper& stepper, const Method& method, const Scene& scene,
                    const StepperWishes& wishes) {
    constexpr std::string_view option = "--tangent";
    if (wishes.lanes.choice == Lanes::ensemble)
        throw InputError("--tangent is not built for ensembles, whose steps are those of eight "
                         "trajectories",
                         wishes.lanes.place);
    refuse_scale(scene, option);
    const SceneStepper carrier =
        tangent_stepper(method, scene, wishes_of_carrier(stepper, wishes), option);
    const bool is_symmetric =
        hvi::gen::is_symmetric(ExactMethod{{method, wishes.composition}, stepper.method.base});
    StepToEmit main = to_emit(stepper);
    main.options.note = wishes.note;
    stepper.header = emit_with_directions(
        main, to_emit(carrier), is_symmetric ? PulledBack::step_back : PulledBack::columns);
}

}  // namespace hvi::gen
