// `hvi-gen stepper`: a method as a C++ header, for any Hamiltonian or for that of a scene.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cstdio>
#include <memory>

#include "generator/cli/commands.hpp"
#include "generator/cli/method.hpp"
#include "generator/emit/emit.hpp"
#include "generator/emit/names.hpp"
#include "generator/exact/galerkin.hpp"
#include "generator/exact/start.hpp"
#include "generator/plan/facts.hpp"
#include "generator/plan/plan.hpp"

namespace hvi::gen {

namespace {

void check_name(const std::string& name) {
    check_class_name(
        name, Place{std::make_shared<const Source>(Source{"--name", name}), {0, name.size()}});
}

// ---- for any Hamiltonian ----

/// The command that writes the same header again, wherever to.
std::string command(const Tableau& tableau, const StepperOptions& options) {
    std::string text = "hvi-gen stepper " + tableau.origin;
    if (options.separable) text += " --separable";
    if (options.name) text += " --name " + *options.name;
    return text;
}

void write_method(const StepperOptions& options) {
    const Tableau tableau = tableau_of(options.method);
    const Scheme scheme = plan(tableau, {.separable = options.separable});
    const EmitOptions emitted = {.class_name = options.name.value_or(class_name(tableau.name)),
                                 .command = command(tableau, options)};
    const std::string header = emit(tableau, scheme, emitted);
    if (options.explain) std::fputs(dump(scheme).c_str(), stderr);
    write_result(options.output, header);
}

// ---- for a scene ----

std::string command(const Tableau& tableau, const Scene& scene, const StepperOptions& options) {
    std::string text = "hvi-gen stepper " + tableau.origin + " " + scene.hamiltonian.origin;
    if (options.solver == Solver::fixed_point) text += " --solver fixed-point";
    if (options.solver == Solver::newton) text += " --solver newton";
    if (options.solver == Solver::newton_taylor) text += " --solver newton-taylor";
    if (options.energy) text += " --energy";
    if (options.invariants) text += " --invariants";
    if (options.dense) text += " --dense";
    if (options.name) text += " --name " + *options.name;
    return text;
}

/// What is wished for and not built.
void check_solver(const Scheme& scheme, const Scene& scene) {
    if (scheme.is_explicit() || scheme.velocity_form) return;
    const Source& H = *scene.hamiltonian.source;
    const Place place{scene.hamiltonian.source, {0, H.text.size()}};
    if (scheme.solver == Solver::newton && scheme.depends_on_time)
        throw InputError(
            "Newton's method for an H that depends on the time is built only where T is quadratic "
            "and U depends on q and t",
            place);
    if (scheme.solver == Solver::newton_taylor)
        throw InputError("--solver newton-taylor is built only for H = T(p) + U(q) with a "
                         "quadratic T",
                         place, "--solver newton takes any H");
}

std::string explanation(const LoweredScene& lowered, const Scheme& scheme) {
    std::string text = "found in H:\n";
    for (const std::string& fact : facts(lowered)) text += "  " + fact + "\n";
    text += "cost:\n";
    for (const std::string& cost : costs(lowered, scheme)) text += "  " + cost + "\n";
    text += "plan:\n";
    for (const Decision& decision : scheme.decisions)
        text += "  " + decision.what + ": " + decision.why + "\n";
    return text;
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

void write_scene(const StepperOptions& options) {
    const auto [method, scene] = read_scene(options.method, *options.system);
    SceneWishes wishes{options.energy, options.invariants, {}};
    check_members(scene, wishes);
    check_start(scene);

    const auto [tableau, curve] = derive(method, options.dense);
    const LoweredScene lowered = hvi::gen::lowered(scene);
    const Scheme scheme =
        plan(tableau, {.separable = lowered.structure.is_separable,
                       .depends_on_time = lowered.system.time.has_value(),
                       .kinetic_is_quadratic = lowered.structure.kinetic_is_quadratic,
                       .is_quadratic = lowered.structure.is_quadratic,
                       .degrees_of_freedom = lowered.system.degrees_of_freedom(),
                       .has_curve = options.dense,
                       .solver = options.solver});
    check_solver(scheme, scene);
    wishes.curve = curve;
    const std::string name =
        class_name(scene.name.empty() ? tableau.name : scene.name + "-" + tableau.name);
    const EmitOptions emitted = {.class_name = options.name.value_or(name),
                                 .command = command(tableau, scene, options),
                                 .scene = &lowered,
                                 .wishes = wishes};
    const std::string header = emit(tableau, scheme, emitted);
    if (options.explain) std::fputs(explanation(lowered, scheme).c_str(), stderr);
    write_result(options.output, header);
}

}  // namespace

void run(const StepperOptions& options) {
    if (options.name) check_name(*options.name);
    if (options.system)
        write_scene(options);
    else
        write_method(options);
}

}  // namespace hvi::gen
