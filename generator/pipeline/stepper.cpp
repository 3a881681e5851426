// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/pipeline/stepper.hpp"

#include "generator/emit/steps/emit.hpp"
#include "generator/emit/text/names.hpp"
#include "generator/exact/methods/galerkin.hpp"
#include "generator/options/option_table.hpp"
#include "generator/plan/lanes.hpp"
#include "generator/plan/plan.hpp"
#include "generator/scene/start.hpp"

namespace hvi::gen {

namespace {

/// The command that writes the same header again, wherever to.
std::string command(const Tableau& tableau, const StepperWishes& wishes) {
    return "hvi-gen stepper " + tableau.provenance.origin + options_for(wishes);
}

std::string command(const Tableau& tableau, const Scene& scene, const StepperWishes& wishes) {
    return "hvi-gen stepper " + tableau.provenance.origin + " " + scene.hamiltonian.origin +
           options_for(wishes);
}

/// What is wished for and not built.
void check_solver(const Step& step, const Scene& scene) {
    const auto* pairs = std::get_if<PairStep>(&step.form);
    if (pairs == nullptr || !pairs->iteration) return;
    const Source& H = *scene.hamiltonian.source;
    const Place place{scene.hamiltonian.source, {0, H.text.size()}};
    if (pairs->iteration->solver == Solver::newton_taylor)
        throw InputError("--solver newton-taylor is built only for H = T(p) + U(q) with a "
                         "quadratic T",
                         place, "--solver newton takes any H");
}

void check_lanes(const Step& step, const Wish<Lanes>& wished) {
    if (wished.choice != Lanes::stages) return;
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
    refuse(wishes.float128, "--float128", "no processor computes several of these at once");
    refuse(wishes.evaluations, "--evaluations", "one evaluation serves several trajectories");
    const std::string obstacle = obstacle_to_ensemble(step);
    if (!obstacle.empty())
        throw InputError("no ensembles of this method on this H: " + obstacle, place,
                         "they are built for explicit methods, as stormer-verlet and its "
                         "compositions are where H = T(p) + U(q), and for midpoint and gauss:S");
}

/// The method, and the curve of its steps where that is asked for.
struct MethodAndCurve {
    Tableau tableau;
    std::optional<Curve> curve;
};

MethodAndCurve derived(const Method& method, const StepperWishes& wishes) {
    MethodAndCurve result = on_new_ground([&](const Ground& ground) {
        const Derivation derivation = derive_on(ground, method);
        return MethodAndCurve{derivation.tableau, wishes.dense
                                                      ? std::optional(curve(method, derivation))
                                                      : std::nullopt};
    });
    if (!wishes.composition) return result;
    check_composition(*wishes.composition, result.tableau);
    if (wishes.dense)
        throw InputError("--dense is not built for compositions, whose steps have no one curve",
                         wishes.composition->place);
    return result;
}

Step planned(const Tableau& tableau, const SystemProperties& system, const Method& method,
             const Scene& scene, const StepperWishes& wishes) {
    Step step = plan(tableau, system,
                     {.solver = wishes.solver,
                      .lanes = wishes.lanes.choice,
                      .curve = wishes.dense,
                      .composition = wishes.composition,
                      .method = method.place});
    check_solver(step, scene);
    check_lanes(step, wishes.lanes);
    check_ensemble(step, wishes);
    return step;
}

std::string name_of_class(const Given& wished, const std::string& otherwise) {
    return wished ? wished->text : class_name(otherwise);
}

}  // namespace

MethodStepper method_stepper(const Method& method, const StepperWishes& wishes) {
    Tableau tableau = derive(method);
    if (wishes.composition) check_composition(*wishes.composition, tableau);
    Step step = plan(tableau, {.is_separable = wishes.separable},
                     {.composition = wishes.composition, .method = method.place});
    const std::string name = name_of_class(
        wishes.class_name, composed_name(tableau.provenance.name, wishes.composition));
    std::string header =
        emit(tableau, step, {.class_name = name, .command = command(tableau, wishes)});
    return {std::move(tableau), std::move(step), std::move(header)};
}

SceneStepper scene_stepper(const Method& method, const Scene& scene, const StepperWishes& wishes) {
    SceneWishes members{wishes.energy, wishes.invariants, wishes.evaluations, wishes.float128, {}};
    check_members(scene, members);
    check_start(scene);
    auto [tableau, curve] = derived(method, wishes);
    members.curve = std::move(curve);
    System system = system_of(scene);
    GradientKernels gradients = gradient_kernels(system);
    Step step = planned(tableau, properties(system, gradients), method, scene, wishes);
    Evaluations evaluations = hvi::gen::evaluations(system, std::move(gradients), step);
    std::string method_name = composed_name(tableau.provenance.name, wishes.composition);
    std::string name = name_of_class(
        wishes.class_name, scene.name.empty() ? method_name : scene.name + "-" + method_name);
    std::string header = emit(tableau, step,
                              {.class_name = name,
                               .command = command(tableau, scene, wishes),
                               .system = &system,
                               .wishes = members,
                               .evaluations = &evaluations});
    return {std::move(tableau), std::move(method_name), method.place,           scene,
            std::move(system),  std::move(step),        std::move(evaluations), std::move(name),
            std::move(header)};
}

}  // namespace hvi::gen
