// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/simulate/simulation.hpp"

#include <fmt/format.h>

#include "generator/emit/text/text.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

constexpr const char* header_name = "stepper.hpp";

std::string lines(const std::vector<std::string>& items) {
    return fmt::format("{}", fmt::join(items, ",\n"));
}

std::string quoted(const std::vector<std::string>& names) {
    std::vector<std::string> items;
    for (const std::string& name : names) items.push_back('"' + name + '"');
    return lines(items);
}

/// The members of the stepper that compute what a run is to keep. Where H depends on the time the
/// energy is among the columns too, but nothing is said of its departure.
std::string values(const std::vector<std::string>& conserved) {
    std::vector<std::string> items;
    for (const std::string& name : conserved) items.push_back(fmt::format("stepper.{}(x)", name));
    return lines(items);
}

}  // namespace

std::vector<std::string> conserved_names(const System& system) {
    std::vector<std::string> names;
    if (!system.time) names.emplace_back("energy");
    for (const SystemValue& invariant : system.invariants) names.push_back(invariant.name);
    return names;
}

std::vector<NameBox> column_names(const RunSubject& subject) {
    std::vector<NameBox> names = subject.coordinates;
    names.insert(names.end(), subject.momenta.begin(), subject.momenta.end());
    for (const std::string& name : subject.conserved) names.push_back(name_box(name));
    return names;
}

namespace {

std::vector<NameBox> boxes(const std::vector<std::string>& names) {
    std::vector<NameBox> result;
    for (const std::string& name : names) result.push_back(name_box(name));
    return result;
}

std::vector<NameBox> boxes(const std::vector<LoopFamily>& families,
                           const std::map<std::string, long>& sizes) {
    std::vector<NameBox> result;
    for (const LoopFamily& family : families) {
        result.push_back({family.name, {}});
        for (const LoopRange& range : family.ranges)
            result.back().ranges.push_back({range.first.at(sizes), range.last.at(sizes)});
    }
    return result;
}

}  // namespace

RunSubject run_subject(const SceneStepper& stepper) {
    check_simulation(stepper);
    const System& system = stepper.system;
    return {.scene = stepper.scene.name,
            .description = stepper.scene.description,
            .method = stepper.method.name(),
            .title = stepper.method.title(),
            .function_letter = system.function_letter(),
            .coordinates = boxes(system.coordinates),
            .momenta = boxes(system.momenta),
            .conserved = conserved_names(system),
            .sizes = function_of(stepper.scene).sizes,
            .program = simulation_program(stepper)};
}

RunSubject run_subject(const LoopStepper& stepper) {
    const LoopSystem& system = stepper.system;
    std::map<std::string, long> sizes;
    for (const LoopSize& size : system.sizes) sizes[size.name] = size.value;
    std::vector<std::string> conserved{"energy"};
    for (const LoopInvariant& invariant : system.invariants) conserved.push_back(invariant.name);
    return {.scene = system.name,
            .description = system.description,
            .method = stepper.method.name(),
            .title = stepper.method.title(),
            .coordinates = boxes(system.coordinates, sizes),
            .momenta = boxes(system.momenta, sizes),
            .conserved = conserved,
            .sizes = {sizes.begin(), sizes.end()},
            .program = {fill("large_driver.cpp.in", {{"header", header_name},
                                                     {"stepper", stepper.class_name},
                                                     {"invariants", quoted(conserved)},
                                                     {"count", std::to_string(conserved.size())},
                                                     {"values", values(conserved)}}),
                        {{header_name, stepper.header}},
                        {}}};
}

void check_simulation(const SceneStepper& stepper) {
    if (!stepper.step.from_parameter) return;
    const std::string& name = stepper.step.from_parameter->numbers.parameter;
    for (const SystemParameter& parameter : stepper.system.parameters)
        if (parameter.name == name) return;
    throw InputError(fmt::format("the parameter `{}` of the method has no value", name),
                     stepper.method.place, fmt::format("give it one: --param {}=1", name));
}

StepperWishes simulation_wishes(Solver solver, std::optional<Composition> composition) {
    return {.solver = solver,
            .energy = true,
            .invariants = true,
            .evaluations = true,
            .composition = std::move(composition)};
}

ProgramText simulation_program(const SceneStepper& stepper) { return driver_program(stepper, {}); }

ProgramText driver_program(const SceneStepper& stepper, const Driver& driver) {
    const System& system = stepper.system;
    const std::vector<std::string> conserved = conserved_names(system);
    const auto fact = [](bool is_true) { return std::string(is_true ? "true" : "false"); };
    return {fill("driver.cpp.in", {{"driver", driver.header},
                                   {"main", driver.main},
                                   {"header", header_name},
                                   {"stepper", stepper.class_name},
                                   {"invariants", quoted(conserved)},
                                   {"count", std::to_string(conserved.size())},
                                   {"values", values(conserved)},
                                   {"separable", fact(stepper.step.is_separable())},
                                   {"joint", fact(stepper.step.slopes == Slopes::joint)},
                                   {"quadratic", fact(system.structure.kinetic_is_quadratic)},
                                   {"time", fact(system.time.has_value())},
                                   {"lagrangian", fact(system.side == Side::lagrangian)}}),
            {{header_name, stepper.header}},
            driver.libraries};
}

ProgramText reference_program(const SceneStepper& stepper) {
    return {fill("reference.cpp.in", {{"header", header_name}, {"stepper", stepper.class_name}}),
            {{header_name, stepper.header}}};
}

ReferenceSolution find_reference(const std::filesystem::path& program, double until,
                                 std::int64_t count, double wanted, double seconds) {
    const Answers answers = ask(program, {fmt::format("{}", until), std::to_string(count),
                                          fmt::format("{}", wanted), fmt::format("{}", seconds)});
    return {static_cast<int>(answers.integer("bits")), answers.number("error"),
            answers.numbers("end")};
}

namespace {

Answers ask_for_tables(const std::filesystem::path& program, const Steps& steps,
                       const std::vector<TableWishes>& tables,
                       const std::function<void(double)>& on_progress) {
    std::vector<std::string> words{"trajectory", fmt::format("{}", steps.size),
                                   std::to_string(steps.count)};
    std::filesystem::path last;
    for (const TableWishes& table : tables) {
        if (!last.empty()) words.push_back(last.string());
        words.insert(words.end(), {std::to_string(table.every), text(table.columns)});
        last = table.file;
    }
    return ask(program, words, last, on_progress);
}

}  // namespace

Simulation run_simulation(const std::filesystem::path& program, const RunSubject& subject,
                          const Steps& steps, const std::vector<TableWishes>& tables,
                          const std::function<void(double)>& on_progress) {
    const Answers answers = ask_for_tables(program, steps, tables, on_progress);
    Simulation run{answers.text("status"),
                   answers.integer("steps"),
                   answers.integer("rows"),
                   answers.integer("iterations"),
                   answers.integer("evaluations"),
                   answers.number("seconds_of_step"),
                   {}};
    const std::vector<std::string>& names = subject.conserved;
    const auto start = answers.numbers("start", names.size()),
               largest = answers.numbers("largest", names.size()),
               last = answers.numbers("last", names.size());
    for (std::size_t i = 0; i < names.size(); ++i)
        run.conserved.push_back({names[i], start[i], largest[i], last[i]});
    return run;
}

Measurement measure(const std::filesystem::path& program, const Steps& steps, double seconds) {
    return measurement(ask(program, {"measure", fmt::format("{}", steps.size),
                                     std::to_string(steps.count), fmt::format("{}", seconds)}));
}

Measurement measurement(const Answers& answers) {
    Measurement result;
    result.status = answers.text("status");
    result.steps = answers.integer("steps");
    result.iterations = answers.integer("iterations");
    result.evaluations = answers.integer("evaluations");
    result.departures = answers.numbers("largest");
    result.end = answers.numbers("end");
    result.velocity = answers.numbers("velocity", answers.has("velocity") ? result.end.size() : 0);
    if (answers.has("seconds")) {
        result.seconds = answers.number("seconds");
        result.spread = answers.number("spread");
    }
    return result;
}

DepartureSamples sample_departures(const std::filesystem::path& program, const Steps& steps,
                                   std::int64_t samples) {
    return departure_samples(ask(program, {"departures", fmt::format("{}", steps.size),
                                           std::to_string(steps.count), std::to_string(samples)}));
}

DepartureSamples departure_samples(const Answers& answers) {
    DepartureSamples result{answers.numbers("time"), {}};
    const std::vector<double> all = answers.numbers("departure");
    if (result.times.empty()) return result;
    const std::size_t kinds = all.size() / result.times.size();
    if (all.size() % result.times.size() != 0)
        throw answers.unexpected("some parts of a run have more departures than others");
    for (std::size_t i = 0; i < result.times.size(); ++i) {
        const auto begin = all.begin() + static_cast<std::ptrdiff_t>(i * kinds);
        result.departures.emplace_back(begin, begin + static_cast<std::ptrdiff_t>(kinds));
    }
    return result;
}

}  // namespace hvi::gen
