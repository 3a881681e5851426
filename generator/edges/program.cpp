// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/edges/program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <memory>

#include "generator/edges/dual_functions.hpp"
#include "generator/emit/system/scene_code.hpp"
#include "generator/emit/text/text.hpp"
#include "generator/scene/step_count.hpp"
#include "generator/simulate/peers.hpp"
#include "generator/support/child.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

/// Returns a statement for each parameter.
std::string set_parameters(const System& system) {
    const NodeNames names = parameter_names(system);
    std::string text;
    std::size_t i = 0;
    for (const SystemParameter& parameter : system.parameters)
        text += fmt::format("{}{} = values.at({});", text.empty() ? "" : "\n",
                            names.at(parameter.node), i++);
    return text;
}

std::string failure_of(int status) {
    if (status == 0) return "";
    if (status == 128 + SIGALRM) return "no end: ended by its time limit";
    if (status > 128) return fmt::format("a crash: ended by signal {}", status - 128);
    return fmt::format("a program that ends with {}", status);
}

}  // namespace

Scene edge_scene(const std::string& name) { return find_scene(given("SCENE", name)); }

double usual_step(const Scene& scene) {
    const SceneTimes times = times_of(scene);
    HVI_CHECK(times.step.has_value());
    return nearest_value(times, *times.step);
}

Advance::Advance(const Heard& heard) : failure(heard.failure) {
    if (!failure.empty()) return;
    status = heard.answers.text("status");
    steps = heard.answers.integer("steps");
    untouched = heard.answers.integer("untouched") == 1;
    iterations = static_cast<double>(heard.answers.integer("iterations")) /
                 static_cast<double>(std::max(1L, steps));
}

std::optional<EdgeCheck> refusal_of_general_form(const ExactMethod& method, const Scene& scene) {
    if (!std::holds_alternative<GalerkinRule>(method.base)) return {};
    const auto check = [&](const Error& error) {
        return EdgeCheck{method.name(), scene.name,
                         "a step",      "a step, or a reason why there is none",
                         error.what(),  true};
    };
    try {
        static_cast<void>(scene_stepper(method.method, scene, {}));
    } catch (const InputError& error) { return check(error); } catch (const MathError& error) {
        return check(error);
    }
    return {};
}

EdgeProgram::EdgeProgram(Builds& builds, const ComposedMethod& method, const Scene& scene,
                         Solver solver) {
    const SceneStepper stepper = scene_stepper(method.method, scene,
                                               {.solver = solver,
                                                .unroll = Unroll::yes,
                                                .energy = true,
                                                .composition = method.composition});
    is_explicit_ = stepper.step.is_explicit();
    build_ = builds.order(
        program_around(stepper, "edge.cpp.in",
                       {{"stepper", stepper.class_name}, {"set", set_parameters(stepper.system)}}));
}

EdgeProgram EdgeProgram::symplectic(Builds& builds, const ComposedMethod& method,
                                    const Scene& scene) {
    const SceneStepper stepper =
        scene_stepper(method.method, with_dual_functions(scene),
                      {.unroll = Unroll::yes, .float128 = true, .composition = method.composition});
    EdgeProgram program;
    program.is_explicit_ = stepper.step.is_explicit();
    program.build_ = builds.order(
        program_around(stepper, "symplectic.cpp.in", {{"stepper", stepper.class_name}}));
    return program;
}

EdgeProgram EdgeProgram::naive(Builds& builds, const Scene& scene) {
    EdgeProgram program;
    program.build_ = builds.order(driver_program(
        stepper_for_peers(lowered(scene, {.choice = Unroll::yes})), {"naive", "naive::main", {}}));
    return program;
}

Heard EdgeProgram::ask(std::vector<std::string> words) const {
    const std::filesystem::path program = built(build_);
    words.insert(words.begin(), program.string());
    Heard heard{Answers(program)};
    const ChildResult ended =
        run_child(words, ".", [&](std::string_view line) { heard.answers.hear(line); });
    heard.failure = failure_of(ended.status);
    return heard;
}

Heard EdgeProgram::ask(const std::string& command, double h, long steps,
                       const std::vector<double>& state, const std::vector<double>& values) const {
    std::vector<std::string> words{command, fmt::format("{}", h), std::to_string(steps)};
    for (const double value : state) words.push_back(fmt::format("{}", value));
    for (const double value : values) words.push_back(fmt::format("{}", value));
    Heard heard = ask(words);
    if (heard.failure.empty() && (command == "advance" || command == "return"))
        for (const char* key : {"largest", "end"})
            static_cast<void>(heard.answers.numbers(key, state.size()));
    return heard;
}

}  // namespace hvi::gen
