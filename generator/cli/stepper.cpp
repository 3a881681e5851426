// `hvi-gen stepper`: a method as a C++ header, for any Hamiltonian or for that of a scene.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cstdio>
#include <memory>

#include "generator/cli/advice.hpp"
#include "generator/cli/commands.hpp"
#include "generator/cli/method.hpp"
#include "generator/emit/steps/banner.hpp"
#include "generator/emit/steps/emit.hpp"
#include "generator/emit/steps/scene_stepper.hpp"
#include "generator/emit/text/names.hpp"
#include "generator/plan/facts.hpp"
#include "generator/plan/plan.hpp"
#include "generator/support/option_place.hpp"
#include "generator/support/process.hpp"

namespace hvi::gen {

namespace {

void check_name(const std::string& name) { check_class_name(name, option_place("--name", name)); }

// ---- for any Hamiltonian ----

/// The command that writes the same header again, wherever to.
std::string command(const Tableau& tableau, const StepperOptions& options) {
    std::string text = "hvi-gen stepper " + tableau.origin;
    if (options.separable) text += " --separable";
    if (options.wishes.composition) text += " --compose " + options.wishes.composition->name;
    if (options.wishes.class_name) text += " --name " + *options.wishes.class_name;
    return text;
}

void write_method(const StepperOptions& options) {
    const Tableau tableau = tableau_of(options.method);
    const std::optional<Composition>& composition = options.wishes.composition;
    if (composition)
        check_composition(*composition, tableau, option_place("--compose", composition->name));
    const Scheme scheme =
        plan(tableau, {.separable = options.separable, .composition = composition});
    const std::string name = composed_name(tableau.name, composition);
    const EmitOptions emitted = {.class_name = options.wishes.class_name.value_or(class_name(name)),
                                 .command = command(tableau, options)};
    const std::string header = emit(tableau, scheme, emitted);
    if (options.explain) std::fputs(dump(scheme).c_str(), stderr);
    write_result(options.output, header);
}

// ---- for a scene ----

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

void write_scene(const StepperOptions& options) {
    const auto [method, scene] = read_scene(options.method, *options.system);
    const SceneStepper stepper = scene_stepper(method, scene, options.wishes);
    if (options.explain) std::fputs(explanation(stepper.lowered, stepper.scheme).c_str(), stderr);
    write_result(options.output, stepper.header);
}

/// With the method and the solver that measuring finds.
void write_advised(const StepperOptions& options) {
    const InterruptionsHeld held;
    const AdvisedOptions advice = advised({options.method.parameters, *options.system,
                                           options.until, *options.accuracy, options.wishes.dense});
    MethodOptions method_options = options.method;
    method_options.name = advice.method;
    const auto [method, scene] = read_scene(method_options, *options.system);
    StepperWishes wishes = options.wishes;
    wishes.solver = advice.solver;
    wishes.composition = advice.composition;
    const SceneStepper stepper = scene_stepper(method, scene, wishes);
    if (options.explain) std::fputs(explanation(stepper.lowered, stepper.scheme).c_str(), stderr);
    std::fputs((command_in(stepper.header) + "\n" + advice.note + "\n").c_str(), stderr);
    write_result(options.output, with_note(stepper.header, advice.note));
}

}  // namespace

void run(const StepperOptions& options) {
    if (options.wishes.class_name) check_name(*options.wishes.class_name);
    if (options.accuracy)
        write_advised(options);
    else if (options.system)
        write_scene(options);
    else
        write_method(options);
}

}  // namespace hvi::gen
