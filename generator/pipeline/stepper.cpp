// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/pipeline/stepper.hpp"

#include "generator/emit/steps/emit.hpp"
#include "generator/emit/text/names.hpp"
#include "generator/exact/methods/galerkin.hpp"
#include "generator/hamiltonian/fibre_rank.hpp"
#include "generator/hamiltonian/legendre.hpp"
#include "generator/lower/system.hpp"
#include "generator/options/option_table.hpp"
#include "generator/pipeline/refusals.hpp"
#include "generator/plan/plan.hpp"
#include "generator/read/scene_times.hpp"
#include "generator/scene/start.hpp"

namespace hvi::gen {

namespace {

/// The command that writes the same header again, wherever to.
std::string command(const OneStepMethod& method, const StepperWishes& wishes) {
    return "hvi-gen stepper " + method.provenance().origin + options_for(wishes);
}

/// Whether (4.6e) has to determine the P from the V. NOTE: rows of zeros are left to the plan.
bool is_overdetermined(const OneStepMethod& method, const System& system) {
    return std::holds_alternative<GalerkinRule>(method.base) && system.side == Side::hamiltonian &&
           !is_degenerate(hessian_of(system));
}

/// Whether (4.14) makes steps of the L of a scene; nothing is asked of an H.
void check_lagrangian(const WrittenOutScene& scene) {
    if (const auto* L = std::get_if<Lagrangian>(&scene.mechanics)) check_regular(*L);
}

/// NOTE: a step of kicks and drifts keeps the slopes of its drifts, and the curve is one of kicks.
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

Step planned(const OneStepMethod& method, const SystemProperties& system,
             const StepperWishes& wishes) {
    return plan(method, system,
                {.solver = wishes.solver,
                 .lanes = wishes.lanes.choice,
                 .curve = wishes.dense,
                 .action = wishes.action});
}

std::string name_of_class(const Given& wished, const std::string& otherwise) {
    return wished ? wished->text : class_name(otherwise);
}

/// A scene as its texts have it.
struct SceneText {
    std::string origin;  ///< as the command line has it
    Place place;         ///< of H or L
    std::vector<OwnHeader> own_headers;
};

SceneWishes members_of(const StepperWishes& wishes) {
    return {.energy = wishes.energy,
            .invariants = wishes.invariants,
            .evaluations = wishes.evaluations,
            .float128 = wishes.float128,
            .action = wishes.action};
}

/// The way from a system to a header.
SceneStepper stepper_of(const Method& wished, MethodAndCurve derived, System system,
                        const SceneText& scene, const StepperWishes& wishes, SceneWishes members) {
    auto& [method, curve] = derived;
    members.curve = std::move(curve);
    const bool is_written_out = system.is_written_out();
    GradientKernels gradients = is_written_out ? gradient_kernels(system) : GradientKernels{};
    Step step = planned(method, is_written_out ? properties(system, gradients) : properties(system),
                        wishes);
    check_step(step, wished, wishes, scene.place);
    check_newton(system, step, scene.place);
    check_curve(step, members.curve, wished);
    std::optional<Evaluations> evaluations;
    if (is_written_out) { evaluations = hvi::gen::evaluations(system, std::move(gradients), step); }
    std::string name = name_of_class(
        wishes.class_name, system.name.empty() ? method.name() : system.name + "-" + method.name());
    std::string header = emit(method, step,
                              {.class_name = name,
                               .command = "hvi-gen stepper " + method.provenance().origin + " " +
                                          scene.origin + options_for(wishes),
                               .system = &system,
                               .wishes = members,
                               .evaluations = evaluations ? &*evaluations : nullptr});
    return {std::move(method), std::move(system), std::move(step),  std::move(evaluations),
            std::move(name),   std::move(header), scene.own_headers};
}

}  // namespace

MethodStepper method_stepper(const Method& wished, const StepperWishes& wishes) {
    OneStepMethod method = composed(derive_any(wished), wished, wishes);
    Step step = plan(method, {.is_separable = wishes.separable});
    const std::string name = name_of_class(wishes.class_name, method.name());
    std::string header =
        emit(method, step, {.class_name = name, .command = command(method, wishes)});
    return {std::move(method), std::move(step), std::move(header)};
}

namespace {

SceneStepper written_out_stepper(const Method& wished, const WrittenOutScene& scene,
                                 const StepperWishes& wishes) {
    const SceneWishes members = members_of(wishes);
    check_members(scene, members);
    check_own_names(scene.own);
    if (wishes.action) { refuse_rotations(function_of(scene), "--action"); }
    check_start(scene);
    check_lagrangian(scene);
    MethodAndCurve method = derived(wished, wishes);
    System system = system_of(scene);
    if (is_overdetermined(method.method, system))
        check_fibre_rank(hamiltonian_of(scene), wished.place);
    const MechanicalFunction& function = function_of(scene);
    return stepper_of(wished, std::move(method), std::move(system),
                      {function.origin, whole(function.source), scene.own.headers}, wishes,
                      members);
}

SceneStepper loop_stepper(const Method& wished, const Scene& scene, const StepperWishes& wishes) {
    const Place place = whole(scene.function.source);
    check_wishes_of_any_size(wishes, place);
    check_own_names(scene.own);
    for (const NamedIndexed& invariant : scene.invariants) {
        check_function_name(invariant.name, invariant.place_of_name);
    }
    // NOTE: the energy and invariants are members of every one.
    SceneWishes members = members_of(wishes);
    members.energy = members.invariants = true;
    return stepper_of(wished, derived(wished, wishes), system_of(scene),
                      {scene.origin, place, scene.own.headers}, wishes, members);
}

SceneStepper with_reason(SceneStepper stepper, const UnrollDecision& unrolling) {
    stepper.unrolling = unrolling;
    return stepper;
}

}  // namespace

SceneStepper scene_stepper(const Method& wished, const Scene& scene, const StepperWishes& wishes) {
    SceneStepper stepper = by_unrolling(
        scene, {wishes.unroll, wish_without_loops(wishes)},
        [&](const UnrollDecision& why) {
            return with_reason(loop_stepper(wished, scene, wishes), why);
        },
        [&](const WrittenOutScene& written, const UnrollDecision& why) {
            return with_reason(written_out_stepper(wished, written, wishes), why);
        });
    static_cast<void>(times_of(scene));  // whose words are checked there
    return stepper;
}

}  // namespace hvi::gen
