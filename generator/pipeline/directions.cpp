// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/pipeline/directions.hpp"

#include <fmt/format.h>

#include <algorithm>

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

/// Wishes for a stepper of the motion together with a direction.
StepperWishes wishes_of_carrier(const StepperWishes& wishes) {
    StepperWishes result;
    result.solver = wishes.solver;
    result.sweeps = wishes.sweeps;
    result.unroll = wishes.unroll;
    result.composition = wishes.composition;
    result.float128 = wishes.float128;
    result.lanes = {wishes.lanes.choice};
    return result;
}

/// Whether each momentum of a stage is that of a position.
bool has_pairs(const Step& step) {
    return std::holds_alternative<PairStep>(step.form) &&
           step.positions.size() == step.momenta.size();
}

/// Whether steps are flows of parts of H.
bool has_flows(const SceneStepper& stepper) { return stepper.system.parts.has_value(); }

/// Whether the steps themselves carry directions: those that solve nothing, and those whose
/// unknowns are stages of an H that is written out. NOTE: counted sweeps leave no equations to
/// differentiate. The same sweeps of the motion together with a direction are their derivative.
bool carries_along(const SceneStepper& stepper, const StepperWishes& wishes) {
    const Step& step = stepper.step;
    if (has_flows(stepper)) { return true; }
    if (step.container != Container::arrays || stepper.system.side != Side::hamiltonian ||
        wishes.float128) {
        return false;
    }
    if (std::holds_alternative<ExplicitStep>(step.form)) { return true; }
    return !step.from_parameter && step.iteration() != nullptr && wishes.sweeps.choice == 0 &&
           (has_pairs(step) || std::holds_alternative<VelocityStep>(step.form));
}

/// Makes them do so.
void carry_directions(SceneStepper& stepper) {
    stepper.step.carries = Carries::directions;
    if (has_flows(stepper)) {
        stepper.step.decisions.push_back({"directions go along with (q, p) in dual numbers",
                                          "each flow is differentiated as it is computed"});
        return;
    }
    stepper.step.decisions.push_back(
        {"directions go along with the stages of (q, p)",
         "their equations are linear, and share what second derivatives have of these"});
    stepper.evaluations->directions = direction_kernels(stepper.system);
}

/// A stepper whose steps are to be computed in dual numbers, as those of rotations and those of
/// flows of parts of H are. NOTE: six
/// directions take four times as long as one, and eight more than six and two, as they do not stay
/// in registers.
SceneStepper stepper_in_duals(const SceneStepper& stepper, const Method& method, const Scene& scene,
                              StepperWishes wishes, std::string_view what, std::size_t count) {
    constexpr std::size_t most_parts = 6;
    check_own_functions(scene, what);
    if (stepper.step.container != Container::arrays)
        throw InputError(
            fmt::format("{} is not built for rotations where sums stay loops", what),
            whole(scene.function.source),
            fmt::format("--unroll yes writes the sums out, up to {} degrees of freedom",
                        most_degrees_of_freedom));
    wishes.float128 = true;
    wishes.lanes = {Lanes::none};
    SceneStepper result = scene_stepper(method, scene, wishes);
    result.step.dual_parts = std::min(count, most_parts);
    return result;
}

}  // namespace

void add_directions(SceneStepper& stepper, const Method& method, const Scene& scene,
                    const StepperWishes& wishes) {
    constexpr std::string_view option = "--tangent";
    if (wishes.lanes.choice == Lanes::gpu)
        throw InputError("--tangent is not built for --lanes gpu, whose states are plain numbers",
                         wishes.lanes.place);
    if (wishes.lanes.choice == Lanes::ensemble)
        throw InputError("--tangent is not built for ensembles, whose steps are those of eight "
                         "trajectories",
                         wishes.lanes.place);
    check_motion(scene, option);
    const bool is_symmetric =
        hvi::gen::is_symmetric(ExactMethod{{method, wishes.composition}, stepper.method.base});
    const PulledBack pulled_back = is_symmetric ? PulledBack::step_back : PulledBack::columns;
    if (carries_along(stepper, wishes)) {
        carry_directions(stepper);
        StepToEmit along = to_emit(stepper);
        along.options.note = wishes.note;
        stepper.header = emit_with_directions(along, pulled_back);
        return;
    }
    StepToEmit apart = to_emit(stepper);
    apart.options.note = wishes.note;
    const SceneStepper carrier = tangent_stepper(method, scene, wishes_of_carrier(wishes), option);
    stepper.header = emit_with_directions_apart(apart, to_emit(carrier), pulled_back);
}

SceneStepper stepper_of_directions(const SceneStepper& stepper, const Method& method,
                                   const Scene& scene, const StepperWishes& wishes,
                                   std::string_view what, std::size_t count) {
    if (!scene.rotations.texts.empty() || has_flows(stepper))
        return stepper_in_duals(stepper, method, scene, wishes, what, count);
    if (!carries_along(stepper, wishes)) return tangent_stepper(method, scene, wishes, what);
    check_motion(scene, what);
    SceneStepper result = stepper;
    carry_directions(result);
    return result;
}

SceneStepper stepper_of_parameter(const SceneStepper& stepper, const Method& method,
                                  const Scene& scene, const StepperWishes& wishes,
                                  const std::string& parameter, std::string_view what) {
    refuse_rotations(scene, what);
    SceneStepper result = stepper_in_duals(stepper, method, scene, wishes, what, 1);
    result.differentiated_by = parameter;
    return result;
}

}  // namespace hvi::gen
