// `hvi-gen stepper`: a method as a C++ header, for any Hamiltonian or for a scene.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/pipeline/stepper.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <memory>

#include "generator/cli/advice.hpp"
#include "generator/cli/commands.hpp"
#include "generator/cli/method.hpp"
#include "generator/emit/steps/banner.hpp"
#include "generator/emit/text/names.hpp"
#include "generator/pipeline/stage.hpp"
#include "generator/plan/facts.hpp"
#include "generator/support/process.hpp"

namespace hvi::gen {

namespace {

void write_method(const StepperOptions& options) {
    const Method method = method_of(options.method);
    const MethodStepper stepper = method_stepper(method, options.wishes);
    if (options.explain) std::fputs(dump(stepper.step).c_str(), stderr);
    write_result(options.output,
                 options.dump ? dump(method, stepper, *options.dump) : stepper.header);
}

std::string explanation(const SceneStepper& stepper) {
    std::string text = fmt::format("found in {}:\n", stepper.system.function_letter());
    for (const std::string& fact : facts(stepper.system)) text += "  " + fact + "\n";
    if (stepper.evaluations) {
        text += "cost:\n";
        for (const std::string& cost : costs(stepper.system, stepper.step, *stepper.evaluations))
            text += "  " + cost + "\n";
    }
    text += "plan:\n";
    text += fmt::format("  sums {}: {}\n",
                        stepper.unrolling.writes_out ? "are written out" : "stay loops",
                        stepper.unrolling.why);
    for (const Decision& decision : stepper.step.decisions)
        text += "  " + decision.what + ": " + decision.why + "\n";
    return text;
}

/// NOTE: with both files in one directory, an #include would find the stepper in the header's
/// place.
void check_output(const StepperOptions& options, const OwnFunctions& own) {
    if (!options.output) return;
    for (const OwnFunction& function : own.functions) {
        if (std::filesystem::path(function.header).filename() != options.output->filename())
            continue;
        throw InputError(fmt::format("the stepper would be called as the header of `{}`, {}",
                                     function.name, function.header),
                         function.place, "give the file of -o another name");
    }
}

void write_scene(const StepperOptions& options) {
    const MethodAndScene wished = read_scene(options.method, *options.system);
    check_output(options, wished.scene.own);
    const SceneStepper stepper = scene_stepper(wished.method, wished.scene, options.wishes);
    if (options.explain) std::fputs(explanation(stepper).c_str(), stderr);
    write_result(options.output,
                 options.dump ? dump(wished.method, stepper, *options.dump) : stepper.header);
}

/// Writes a stepper with the method and the solver that measuring finds.
void write_advised(const StepperOptions& options) {
    const InterruptionsHeld held;
    const AdvisedOptions advice =
        advised({options.method.parameters, *options.system, options.until, *options.accuracy,
                 options.budget, options.wishes.dense, options.wishes.action, options.explain});
    if (!advice.shortfall.empty())
        throw MathError(advice.shortfall, {},
                        "ask for less, for an earlier end by --until, or for more by --budget");
    MethodOptions method_options = options.method;
    method_options.name = given("--method", advice.method);
    StepperWishes wishes = options.wishes;
    wishes.solver = advice.solver;
    wishes.sweeps.choice = advice.sweeps;
    wishes.composition = advice.composition;
    const MethodAndScene both = read_scene(method_options, *options.system);
    wishes.note = advice.note;
    const SceneStepper stepper = scene_stepper(both.method, both.scene, wishes);
    if (options.explain) std::fputs(explanation(stepper).c_str(), stderr);
    std::fputs((stepper.command + "\n" + advice.note + "\n").c_str(), stderr);
    write_result(options.output, stepper.header);
}

}  // namespace

void run(const StepperOptions& options) {
    if (const Given& name = options.wishes.class_name) check_class_name(name->text, whole(name));
    if (options.accuracy)
        write_advised(options);
    else if (options.system)
        write_scene(options);
    else
        write_method(options);
}

}  // namespace hvi::gen
