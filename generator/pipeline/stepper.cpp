// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/pipeline/stepper.hpp"

#include "generator/emit/steps/emit.hpp"
#include "generator/emit/text/names.hpp"
#include "generator/exact/methods/galerkin.hpp"
#include "generator/hamiltonian/fibre_rank.hpp"
#include "generator/hamiltonian/legendre.hpp"
#include "generator/options/option_table.hpp"
#include "generator/plan/lanes.hpp"
#include "generator/plan/plan.hpp"
#include "generator/scene/start.hpp"

namespace hvi::gen {

namespace {

/// The command that writes the same header again, wherever to.
std::string command(const OneStepMethod& method, const StepperWishes& wishes) {
    return "hvi-gen stepper " + method.provenance().origin + options_for(wishes);
}

std::string command(const OneStepMethod& method, const Scene& scene, const StepperWishes& wishes) {
    return "hvi-gen stepper " + method.provenance().origin + " " + function_of(scene).origin +
           options_for(wishes);
}

/// Whether (4.6e) has to determine the P from the V. NOTE: rows of zeros are left to the plan.
bool is_overdetermined(const OneStepMethod& method, const System& system) {
    return std::holds_alternative<GalerkinRule>(method.base) && system.side == Side::hamiltonian &&
           !is_degenerate(system.hessian);
}

/// Whether (4.14) makes steps of the L of a scene; nothing is asked of an H.
void check_lagrangian(const Scene& scene) {
    if (const auto* L = std::get_if<Lagrangian>(&scene.mechanics)) check_regular(*L);
}

/// What is wished for and not built.
void check_solver(const Step& step, const Scene& scene, const StepperWishes& wishes) {
    const Iteration* iteration = step.iteration();
    if (iteration == nullptr || std::holds_alternative<VelocityStep>(step.form)) return;
    const Place place = whole(function_of(scene).source);
    if (iteration->solver != Solver::newton_taylor) return;
    if (wishes.action)
        throw InputError("--solver newton-taylor solves for positions alone, and --action needs "
                         "the momenta of the stages",
                         place, "--solver newton goes with it");
    throw InputError("--solver newton-taylor is built only for H = T(p) + U(q) with a "
                     "quadratic T",
                     place, "--solver newton takes any H");
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

/// An ensemble, and what is not built for it.
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
                         "compositions are where H = T(p) + U(q), and for midpoint and gauss:S");
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

Step planned(const OneStepMethod& method, const SystemProperties& system, const Scene& scene,
             const StepperWishes& wishes) {
    Step step = plan(method, system,
                     {.solver = wishes.solver,
                      .lanes = wishes.lanes.choice,
                      .curve = wishes.dense,
                      .action = wishes.action});
    check_solver(step, scene, wishes);
    check_lanes(step, wishes);
    check_ensemble(step, wishes);
    return step;
}

std::string name_of_class(const Given& wished, const std::string& otherwise) {
    return wished ? wished->text : class_name(otherwise);
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

SceneStepper scene_stepper(const Method& wished, const Scene& scene, const StepperWishes& wishes) {
    SceneWishes members{.energy = wishes.energy,
                        .invariants = wishes.invariants,
                        .evaluations = wishes.evaluations,
                        .float128 = wishes.float128,
                        .action = wishes.action};
    check_members(scene, members);
    check_own_names(scene.own);
    if (wishes.action) { refuse_rotations(function_of(scene), "--action"); }
    check_start(scene);
    check_lagrangian(scene);
    auto [method, curve] = derived(wished, wishes);
    members.curve = std::move(curve);
    System system = system_of(scene);
    if (is_overdetermined(method, system)) check_fibre_rank(hamiltonian_of(scene), method.place);
    GradientKernels gradients = gradient_kernels(system);
    Step step = planned(method, properties(system, gradients), scene, wishes);
    check_curve(step, members.curve, wished);
    Evaluations evaluations = hvi::gen::evaluations(system, std::move(gradients), step);
    std::string name = name_of_class(
        wishes.class_name, scene.name.empty() ? method.name() : scene.name + "-" + method.name());
    std::string header = emit(method, step,
                              {.class_name = name,
                               .command = command(method, scene, wishes),
                               .system = &system,
                               .wishes = members,
                               .evaluations = &evaluations});
    return {std::move(method),      scene,           std::move(system), std::move(step),
            std::move(evaluations), std::move(name), std::move(header)};
}

}  // namespace hvi::gen
