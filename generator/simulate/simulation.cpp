// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/simulate/simulation.hpp"

#include <fmt/format.h>

#include <utility>

#include "generator/emit/text/names.hpp"
#include "generator/module/driven.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

std::string lines(const std::vector<std::string>& items) {
    return fmt::format("{}", fmt::join(items, ",\n"));
}

std::string quoted(const std::vector<std::string>& names) {
    std::vector<std::string> items;
    for (const std::string& name : names) items.push_back('"' + name + '"');
    return lines(items);
}

/// Returns the stepper's members that compute the conserved quantities of a run. Where H depends on
/// time, the energy is a column too, but its departure is not reported.
std::string values(const std::vector<std::string>& conserved) {
    std::vector<std::string> items;
    for (const std::string& name : conserved)
        items.push_back(fmt::format("*out++ = stepper.{}(x);", member_name(name)));
    return fmt::format("{}", fmt::join(items, "\n"));
}

void add(ProgramText& program, const std::vector<OwnHeader>& own) {
    for (const OwnHeader& header : own)
        program.headers.emplace("scene/" + header.path, header.text);
}

/// NOTE: the stepper's header stands with the user's headers in a directory of their own, under a
/// name that none of them can have. So no file of the program is taken for one of them.
ProgramText program_around(const std::string& stepper, const std::vector<OwnHeader>& own,
                           std::string_view main, Holes holes, std::vector<std::string> libraries) {
    const std::string name = own.empty() ? "stepper.hpp" : "scene/~stepper.hpp";
    holes.emplace("header", name);
    ProgramText program{fill(main, holes), {{name, stepper}}, std::move(libraries)};
    add(program, own);
    return program;
}

/// NOTE: directories are as in program_around().
ProgramText module_text(const std::string& source, const std::vector<OwnHeader>& own) {
    ProgramText text{.main = source, .headers = {}, .artifact = Artifact::library};
    if (own.empty()) return text;
    text.main = "#include \"scene/~module.cpp\"\n";
    text.headers.emplace("scene/~module.cpp", source);
    add(text, own);
    return text;
}

}  // namespace

ProgramText program_around(const SceneStepper& stepper, std::string_view main, const Holes& holes,
                           const std::vector<std::string>& libraries) {
    return program_around(stepper.header, stepper.own_headers, main, holes, libraries);
}

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

std::vector<NameBox> boxes(const System& system, FamilyKind kind) {
    std::vector<NameBox> result;
    if (system.is_written_out()) {
        for (const Access& access : system.accesses)
            if (access.kind == kind) result.push_back(name_box(system.graph.at(access.node).name));
        return result;
    }
    std::map<std::string, long> sizes;
    for (const SystemSize& size : system.sizes) sizes[size.name] = size.value;
    const bool is_q = kind == FamilyKind::coordinate;
    for (const SystemFamily& family : is_q ? system.coordinates : system.conjugates) {
        result.push_back({family.name, {}});
        for (const LoopRange& range : family.ranges)
            result.back().ranges.push_back({range.first.at(sizes), range.last.at(sizes)});
    }
    return result;
}

/// NOTE: momenta of a Lagrangian are names only.
std::vector<NameBox> boxes_of_momenta(const System& system) {
    if (system.side == Side::hamiltonian) return boxes(system, FamilyKind::conjugate);
    std::vector<NameBox> result;
    for (const std::string& name : system.momenta) result.push_back(name_box(name));
    return result;
}

}  // namespace

RunSubject run_subject(const SceneStepper& stepper) {
    check_parameter_of_method(stepper);
    const System& system = stepper.system;
    RunSubject subject{.scene = system.name,
                       .description = system.description,
                       .method = stepper.method.name(),
                       .title = stepper.method.title(),
                       .function_letter = system.function_letter(),
                       .coordinates = boxes(system, FamilyKind::coordinate),
                       .momenta = boxes_of_momenta(system),
                       .conserved = conserved_names(system),
                       .sizes = {}};
    if (system.scaled) {
        subject.coordinates.pop_back();
        subject.momenta.pop_back();
    }
    for (const SystemSize& size : system.sizes) subject.sizes[size.name] = size.value;
    return subject;
}

StepperWishes simulation_wishes(Solver solver, std::optional<Composition> composition) {
    return {.solver = solver,
            .energy = true,
            .invariants = true,
            .evaluations = true,
            .composition = std::move(composition)};
}

namespace {

/// NOTE: files are found from wherever the program is started.
std::string parameters_of(const SceneStepper& stepper) {
    if (!stepper.system.reads_files()) return "Stepper::Parameters{}";
    const std::filesystem::path directory =
        std::filesystem::absolute("." / stepper.system.directory);
    return fmt::format("Stepper::read_parameters({})", text_literal(directory.string()));
}

}  // namespace

ModuleBuild SimulationProgram::order(Builds& builds) const {
    Library whole = library;
    if (solvers) whole.solvers = std::make_shared<LateBuild>(builds, *solvers);
    return {builds.order(text), std::move(whole)};
}

SimulationProgram simulation_program(const SceneStepper& stepper) {
    DrivenModule driven = driven_module(stepper);
    const std::vector<OwnHeader>& own = stepper.own_headers;
    return {module_text(driven.source, own),
            driven.solvers ? std::optional(module_text(*driven.solvers, own)) : std::nullopt,
            {.file = {},
             .directory = stepper.system.directory,
             .parameters = std::move(driven.numbers),
             .looks_at_rows = stepper.step.container == Container::vectors}};
}

ProgramText driver_program(const SceneStepper& stepper, const Driver& driver) {
    const System& system = stepper.system;
    const std::vector<std::string> conserved = conserved_names(system);
    const auto fact = [](bool is_true) { return std::string(is_true ? "true" : "false"); };
    return program_around(stepper, "driver.cpp.in",
                          {{"driver", driver.header},
                           {"main", driver.main},
                           {"stepper", stepper.class_name},
                           {"invariants", quoted(conserved)},
                           {"count", std::to_string(conserved.size())},
                           {"parameters", parameters_of(stepper)},
                           {"values", values(conserved)},
                           {"separable", fact(stepper.step.is_separable())},
                           {"joint", fact(stepper.step.slopes == Slopes::joint)},
                           {"quadratic", fact(system.structure.kinetic_is_quadratic)},
                           {"time", fact(system.time.has_value())},
                           {"lagrangian", fact(system.side == Side::lagrangian)}},
                          driver.libraries);
}

ProgramText reference_program(const SceneStepper& stepper) {
    if (stepper.step.container == Container::vectors)
        return program_around(
            stepper, "large_reference.cpp.in",
            {{"stepper", stepper.class_name}, {"parameters", parameters_of(stepper)}});
    return program_around(
        stepper, "reference.cpp.in",
        {{"stepper", stepper.class_name},
         {"number", stepper.own_headers.empty() ? "hvi::math::Widest" : "long double"}});
}

ReferenceSolution find_reference(const Target& program, double until, std::int64_t count,
                                 double wanted, double seconds) {
    const Answers answers = ask(program, {fmt::format("{}", until), std::to_string(count),
                                          fmt::format("{}", wanted), fmt::format("{}", seconds)});
    return {static_cast<int>(answers.integer("bits")), answers.number("error"),
            answers.numbers("end")};
}

std::optional<WrittenReference> write_reference(const Target& program,
                                                const std::filesystem::path& file, double until,
                                                std::int64_t count, double wanted, double seconds) {
    const Answers answers = ask(program,
                                {fmt::format("{}", until), std::to_string(count),
                                 fmt::format("{}", wanted), fmt::format("{}", seconds)},
                                file);
    if (!answers.has("error")) return {};
    return WrittenReference{static_cast<int>(answers.integer("bits")), answers.number("error")};
}

void write_start(const Target& program, const std::filesystem::path& file) {
    static_cast<void>(ask(program, {}, file));
}
namespace {

/// Returns the event that a driver names.
const DrivenEvent& event_of(const Answers& answers, const std::string& key,
                            const std::vector<DrivenEvent>& events) {
    const auto number = static_cast<std::size_t>(answers.integer(key));
    if (number >= events.size()) throw answers.unexpected("it names no event of the run");
    return events[number];
}

/// Returns the frequencies of columns.
std::vector<ColumnFrequencies> frequencies_of(const std::vector<ColumnBox>& columns,
                                              const Answers& answers) {
    std::vector<ColumnFrequencies> result;
    for_each_column(columns, [&](const std::string& name, std::size_t) {
        result.push_back({name, {}});
    });
    std::vector<std::size_t> counts;
    std::size_t count = 0;
    for (const double each : answers.numbers("terms", result.size())) {
        if (!(each >= 0 && each < 1000)) throw answers.unexpected("it says a wrong count of terms");
        counts.push_back(static_cast<std::size_t>(each));
        count += counts.back();
    }
    const auto frequency = answers.numbers("frequency", count),
               amplitude = answers.numbers("amplitude", count),
               phase = answers.numbers("phase", count),
               uncertainty = answers.numbers("uncertainty", count);
    std::size_t k = 0;
    for (std::size_t column = 0; column < result.size(); ++column)
        for (const std::size_t end = k + counts[column]; k < end; ++k)
            result[column].terms.push_back({frequency[k], amplitude[k], phase[k], uncertainty[k]});
    return result;
}

}  // namespace

std::string fault_of_event(const Answers& answers, const std::vector<DrivenEvent>& events) {
    if (answers.has("accumulates"))
        return fmt::format("the event `{}` comes again and again without time between",
                           event_of(answers, "accumulates", events).name);
    if (answers.has("undefined"))
        return fmt::format("the event `{}` has no number for its `zero`",
                           event_of(answers, "undefined", events).name);
    return {};
}

Simulation run_simulation(const Target& program, const RunSubject& subject,
                          const TrajectoryWishes& wishes,
                          const std::function<void(double)>& on_progress) {
    const Answers answers = ask(program, wishes, on_progress);
    Simulation run;
    run.status = answers.text("status");
    run.steps = answers.integer("steps");
    run.rows = answers.integer("rows");
    run.iterations = answers.integer("iterations");
    run.evaluations = answers.integer("evaluations");
    run.seconds_of_step = answers.number("seconds_of_step");
    run.t = answers.number("t");
    run.rest = answers.number("rest");
    for (const double count : answers.numbers("events", wishes.events.events.size()))
        run.events.push_back(static_cast<std::int64_t>(count));
    if (const std::string fault = fault_of_event(answers, wishes.events.events); !fault.empty())
        run.status = fault;
    if (answers.has("stopped_by"))
        run.stopped_by = event_of(answers, "stopped_by", wishes.events.events).name;
    const std::vector<std::string>& names = subject.conserved;
    const auto start = answers.numbers("start", names.size()),
               largest = answers.numbers("largest", names.size()),
               last = answers.numbers("last", names.size()),
               drift = answers.numbers("drift", names.size());
    for (std::size_t i = 0; i < names.size(); ++i)
        run.conserved.push_back({names[i], start[i], largest[i], last[i], drift[i]});
    run.reduced = answers.numbers("reduced", wishes.reductions.size());
    if (answers.has("motion")) run.energy_of_motion = answers.number("motion");
    if (answers.has("terms")) run.frequencies = frequencies_of(wishes.analysed, answers);
    if (answers.has("unfit"))
        run.unfit =
            name_at(column_names(subject), static_cast<std::size_t>(answers.integer("unfit")));
    return run;
}

Measurement measure(const Target& program, const Steps& steps, double seconds) {
    return measurement(ask(program, {"measure", fmt::format("{}", steps.size),
                                     std::to_string(steps.count), fmt::format("{}", seconds)}));
}

Measurement measure(const Target& program, const Steps& steps, double seconds, double until,
                    const std::filesystem::path& reference) {
    return measurement(ask(program,
                           {"measure", fmt::format("{}", steps.size), std::to_string(steps.count),
                            fmt::format("{}", seconds), fmt::format("{}", until)},
                           reference));
}

double pace(const Target& program, const Steps& steps) {
    return ask(program, {"pace", fmt::format("{}", steps.size), std::to_string(steps.count)})
        .number("seconds_of_step");
}

Measurement measurement(const Answers& answers) {
    Measurement result;
    result.status = answers.text("status");
    result.steps = answers.integer("steps");
    result.iterations = answers.integer("iterations");
    result.evaluations = answers.integer("evaluations");
    result.departures = answers.numbers("largest");
    result.drifts = answers.numbers("drift");
    if (answers.has("error")) {
        result.end = DistanceOfEnd{answers.number("error")};
    } else {
        std::vector<double> state = answers.numbers("end");
        const std::size_t velocities = answers.has("velocity") ? state.size() : 0;
        result.end = EndOfRun{std::move(state), answers.numbers("velocity", velocities)};
    }
    if (answers.has("seconds")) {
        result.seconds = answers.number("seconds");
        result.spread = answers.number("spread");
    }
    return result;
}

DepartureSamples sample_departures(const Target& program, const Steps& steps,
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
