// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/steps/scene_stepper.hpp"

#include "generator/emit/steps/emit.hpp"
#include "generator/emit/text/names.hpp"
#include "generator/exact/functions/start.hpp"
#include "generator/exact/methods/galerkin.hpp"
#include "generator/lower/joint_gradient.hpp"
#include "generator/plan/lanes.hpp"
#include "generator/plan/plan.hpp"
#include "generator/support/option_place.hpp"

namespace hvi::gen {

namespace {

std::string command(const Tableau& tableau, const Scene& scene, const StepperWishes& wishes) {
    std::string text = "hvi-gen stepper " + tableau.origin + " " + scene.hamiltonian.origin;
    if (wishes.solver == Solver::fixed_point) text += " --solver fixed-point";
    if (wishes.solver == Solver::newton) text += " --solver newton";
    if (wishes.solver == Solver::newton_taylor) text += " --solver newton-taylor";
    if (wishes.lanes == Lanes::stages) text += " --lanes stages";
    if (wishes.lanes == Lanes::ensemble) text += " --lanes ensemble";
    if (wishes.lanes == Lanes::none) text += " --lanes none";
    if (wishes.composition) text += " --compose " + wishes.composition->name;
    if (wishes.energy) text += " --energy";
    if (wishes.invariants) text += " --invariants";
    if (wishes.evaluations) text += " --evaluations";
    if (wishes.float128) text += " --float128";
    if (wishes.dense) text += " --dense";
    if (wishes.class_name) text += " --name " + *wishes.class_name;
    return text;
}

/// What is wished for and not built.
void check_solver(const Scheme& scheme, const Scene& scene) {
    if (scheme.is_explicit() || scheme.velocity_form) return;
    const Source& H = *scene.hamiltonian.source;
    const Place place{scene.hamiltonian.source, {0, H.text.size()}};
    if (scheme.solver == Solver::newton_taylor)
        throw InputError("--solver newton-taylor is built only for H = T(p) + U(q) with a "
                         "quadratic T",
                         place, "--solver newton takes any H");
}

void check_lanes(const Scheme& scheme, Lanes wished) {
    if (wished != Lanes::stages) return;
    const std::string obstacle = obstacle_to_stage_lanes(scheme);
    if (obstacle.empty()) return;
    throw InputError("no lanes for the stages of this method on this H: " + obstacle,
                     option_place("--lanes", "stages"),
                     "without --lanes they are used where they can be");
}

/// An ensemble, and what is not built for it.
void check_ensemble(const Scheme& scheme, const StepperWishes& wishes) {
    if (wishes.lanes != Lanes::ensemble) return;
    const Place place = option_place("--lanes", "ensemble");
    const auto refuse = [&](bool is_wished, const char* flag, const char* reason) {
        if (is_wished)
            throw InputError(std::string(flag) + " is not built for ensembles: " + reason, place,
                             "without --lanes ensemble there is a stepper of one trajectory");
    };
    refuse(wishes.dense, "--dense", "trajectories take all their steps at once");
    refuse(wishes.float128, "--float128", "no processor computes several of these at once");
    refuse(wishes.evaluations, "--evaluations", "one evaluation serves several trajectories");
    const std::string obstacle = obstacle_to_ensemble(scheme);
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

MethodAndCurve derive(const Method& method, bool dense) {
    return on_new_ground([&](const Ground& ground) {
        const Derivation derivation = derive_on(ground, method);
        return MethodAndCurve{derivation.tableau,
                              dense ? std::optional(curve(method, derivation)) : std::nullopt};
    });
}

}  // namespace

SceneStepper scene_stepper(const Method& method, const Scene& scene, const StepperWishes& wishes) {
    SceneWishes members{wishes.energy, wishes.invariants, wishes.evaluations, wishes.float128, {}};
    check_members(scene, members);
    check_start(scene);

    auto [tableau, curve] = derive(method, wishes.dense);
    if (wishes.composition) {
        const Place place = option_place("--compose", wishes.composition->name);
        check_composition(*wishes.composition, tableau, place);
        if (wishes.dense)
            throw InputError("--dense is not built for compositions, whose steps have no one curve",
                             place);
    }
    LoweredScene lowered = hvi::gen::lowered(scene);
    Scheme scheme = plan(tableau, {.separable = lowered.structure.is_separable,
                                   .depends_on_time = lowered.system.time.has_value(),
                                   .kinetic_is_quadratic = lowered.structure.kinetic_is_quadratic,
                                   .is_quadratic = lowered.structure.is_quadratic,
                                   .is_degenerate = is_degenerate(lowered.structure),
                                   .joint_gradient_pays = joint_gradient_pays(lowered.system),
                                   .degrees_of_freedom = lowered.system.degrees_of_freedom(),
                                   .has_curve = wishes.dense,
                                   .solver = wishes.solver,
                                   .lanes = wishes.lanes,
                                   .composition = wishes.composition});
    check_solver(scheme, scene);
    check_lanes(scheme, wishes.lanes);
    check_ensemble(scheme, wishes);
    members.curve = std::move(curve);
    std::string method_name = composed_name(tableau.name, wishes.composition);
    std::string name = wishes.class_name.value_or(
        class_name(scene.name.empty() ? method_name : scene.name + "-" + method_name));
    std::string header = emit(tableau, scheme,
                              {.class_name = name,
                               .command = command(tableau, scene, wishes),
                               .scene = &lowered,
                               .wishes = members});
    return {std::move(tableau), std::move(method_name), std::move(lowered),
            std::move(scheme),  std::move(name),        std::move(header)};
}

}  // namespace hvi::gen
