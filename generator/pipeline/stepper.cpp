// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/pipeline/stepper.hpp"

#include <fmt/format.h>

#include "generator/emit/steps/emit.hpp"
#include "generator/emit/text/names.hpp"
#include "generator/exact/methods/galerkin.hpp"
#include "generator/hamiltonian/fibre_rank.hpp"
#include "generator/options/option_table.hpp"
#include "generator/pipeline/directions.hpp"
#include "generator/pipeline/refusals.hpp"
#include "generator/pipeline/split.hpp"
#include "generator/plan/plan.hpp"

namespace hvi::gen {

namespace {

/// Returns the command that writes the same header again, to any place.
std::string command(const OneStepMethod& method, const StepperWishes& wishes) {
    return "hvi-gen stepper " + method.provenance().origin + options_for(wishes);
}

/// Returns whether (4.6e) has to determine the P from the V. NOTE: rows of zeros are left to the
/// plan.
bool is_overdetermined(const OneStepMethod& method, const System& system) {
    return std::holds_alternative<GalerkinRule>(method.base) && system.side == Side::hamiltonian &&
           !is_degenerate(hessian_of(system));
}

/// Refuses a curve that the step cannot have. NOTE: a step of kicks and drifts keeps the slopes of
/// its drifts, and the curve is one of kicks.
void check_curve(const Step& step, const std::optional<Curve>& curve, const Method& method) {
    const bool is_of_kicks =
        curve && curve->of_forces && std::holds_alternative<PairStep>(step.form);
    if (!is_of_kicks || curve->F.front().empty()) return;
    throw InputError("--dense is not built for explicit steps of the general Galerkin form, but "
                     "where the curve is a straight line",
                     method.place);
}

OneStepMethod composed(DerivedMethod base, const Method& method, const StepperWishes& wishes) {
    if (wishes.composition) { check_composition(*wishes.composition, base); }
    return {std::move(base), wishes.composition, method.place};
}

/// The method, and the curve of its steps where that is asked for.
struct MethodAndCurve {
    OneStepMethod method;
    std::optional<Curve> curve;
};

MethodAndCurve derived(const Method& method, const StepperWishes& wishes) {
    if (!wishes.dense) return {composed(derive_any(method), method, wishes), std::nullopt};
    if (!method.splitting.empty())
        throw InputError("--dense is not built for splittings, whose steps have no one curve",
                         method.place, "run --times looks between steps by shorter steps");
    MethodAndCurve result = on_new_ground([&](const Ground& ground) {
        const AnyDerivation derivation = derive_any_on(ground, method);
        return MethodAndCurve{composed(derivation.method, method, wishes),
                              curve(method, derivation)};
    });
    if (wishes.composition)
        throw InputError("--dense is not built for compositions, whose steps have no one curve",
                         wishes.composition->place);
    return result;
}

/// Returns the method with q and p exchanged: where it is explicit it begins with a drift, not with
/// a kick. NOTE: in logarithmic time Stormer-Verlet follows Kepler's ellipse in this order only.
OneStepMethod exchanged(OneStepMethod method) {
    auto* tableau = std::get_if<Tableau>(&method.base);
    if (tableau == nullptr) return method;
    std::swap(tableau->A, tableau->A_tilde);
    std::swap(tableau->c, tableau->c_tilde);
    tableau->galerkin.reset();
    return method;
}

Step planned(const OneStepMethod& method, const SystemProperties& system,
             const StepperWishes& wishes) {
    return plan(method, system,
                {.solver = wishes.sweeps.choice > 0 ? Solver::sweeps : wishes.solver,
                 .sweeps = wishes.sweeps.choice,
                 .lanes = wishes.lanes.choice,
                 .curve = wishes.dense,
                 .action = wishes.action});
}

std::string name_of_class(const Given& wished, const std::string& otherwise) {
    return wished ? wished->text : class_name(otherwise);
}

SceneWishes members_of(const StepperWishes& wishes) {
    return {.energy = wishes.energy,
            .invariants = wishes.invariants,
            .evaluations = wishes.evaluations,
            .float128 = wishes.float128,
            .action = wishes.action};
}

/// Returns the members of the class of the scene. NOTE: with loops each class has the energy and
/// invariants.
SceneWishes members_of(const StepperWishes& wishes, const LoweredScene& scene) {
    SceneWishes members = members_of(wishes);
    if (!scene.written) { members.energy = members.invariants = true; }
    return members;
}

/// Throws InputError for members that no class can have, and for wishes that the scene does not
/// allow.
void check_wishes(const LoweredScene& scene, const StepperWishes& wishes) {
    check_own_names(scene.scene.own);
    if (wishes.action) { refuse_rotations(scene.scene, "--action"); }
    if (scene.written) {
        check_members(*scene.written, members_of(wishes));
        return;
    }
    check_wishes_of_any_size(wishes, scene.place());
    for (const NamedIndexed& invariant : scene.scene.invariants) {
        check_function_name(invariant.name, invariant.place_of_name);
    }
}

/// Plans a step of a lowered scene, and collects all that its header needs.
SceneStepper stepper_of(const Method& wished, MethodAndCurve derived, const LoweredScene& scene,
                        const StepperWishes& wishes) {
    auto& [method, curve] = derived;
    const std::optional<System> split = system_in_parts(wished, scene, wishes);
    const System& system = split ? *split : scene.system;
    if (system.scaled && system.scaled->drifts_first) method = exchanged(std::move(method));
    if (scene.written && is_overdetermined(method, system))
        check_fibre_rank(hamiltonian_of(*scene.written), wished.place);
    SceneWishes members = members_of(wishes, scene);
    members.curve = std::move(curve);
    Step step = planned(
        method, scene.written ? properties(system, scene.gradients) : properties(system), wishes);
    check_step(step, wished, wishes, scene.place());
    check_newton(system, step, scene.place());
    check_functions_on_device(system, wishes);
    check_curve(step, members.curve, wished);
    std::optional<Evaluations> evaluations;
    if (scene.written) { evaluations = hvi::gen::evaluations(system, scene.gradients, step); }
    std::string name = name_of_class(
        wishes.class_name, system.name.empty() ? method.name() : system.name + "-" + method.name());
    std::string command = "hvi-gen stepper " + method.provenance().origin + " " +
                          scene.scene.origin + options_for(wishes);
    std::string header = emit(method, step,
                              {.class_name = name,
                               .command = command,
                               .note = wishes.note,
                               .kept = kept_by_flows(system, scene),
                               .system = &system,
                               .wishes = members,
                               .evaluations = evaluations ? &*evaluations : nullptr});
    return {std::move(method), system,
            std::move(step),   std::move(evaluations),
            std::move(name),   std::move(command),
            std::move(header), scene.scene.own.headers,
            scene.unrolling,   std::move(members)};
}

}  // namespace

MethodStepper method_stepper(const Method& wished, const StepperWishes& wishes) {
    if (!wished.splitting.empty() && !wishes.separable)
        throw InputError("a splitting steps H = T(p) + U(q), or a scene by flows of its parts",
                         wished.place, "add --separable, or name a scene");
    OneStepMethod method = composed(derive_any(wished), wished, wishes);
    Step step = plan(method, {.is_separable = wishes.separable});
    const std::string name = name_of_class(wishes.class_name, method.name());
    std::string header =
        emit(method, step, {.class_name = name, .command = command(method, wishes)});
    return {std::move(method), std::move(step), std::move(header)};
}

SceneStepper scene_stepper(const Method& wished, const LoweredScene& scene,
                           const StepperWishes& wishes) {
    check_wishes(scene, wishes);
    return stepper_of(wished, derived(wished, wishes), scene, wishes);
}

SceneStepper scene_stepper(const ExactMethod& method, const LoweredScene& scene,
                           const StepperWishes& wishes) {
    check_wishes(scene, wishes);
    return stepper_of(method.method,
                      {{method.base, method.composition, method.method.place}, std::nullopt}, scene,
                      wishes);
}

SceneStepper scene_stepper(const Method& wished, const Scene& scene, const StepperWishes& wishes) {
    SceneStepper stepper = by_unrolling(
        scene, {wishes.unroll, wish_without_loops(wishes)},
        [&](const UnrollDecision& why) {
            return scene_stepper(wished, lowered_with_loops(scene, why), wishes);
        },
        [&](WrittenOutScene written, const UnrollDecision& why) {
            return scene_stepper(wished, lowered_written_out(scene, std::move(written), why),
                                 wishes);
        });
    if (wishes.tangent) add_directions(stepper, wished, scene, wishes);
    return stepper;
}

void check_parameter_of_method(const SceneStepper& stepper) {
    if (!stepper.step.from_parameter) return;
    const std::string& name = stepper.step.from_parameter->numbers.parameter;
    for (const SystemParameter& parameter : stepper.system.parameters)
        if (parameter.name == name) return;
    throw InputError(fmt::format("the parameter `{}` of the method has no value", name),
                     stepper.method.place, fmt::format("give it one: --param {}=1", name));
}

}  // namespace hvi::gen
