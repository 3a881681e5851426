// `hvi-gen run`: a scene, integrated from its initial data.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <optional>
#include <utility>
#include <variant>

#include "generator/cli/advice.hpp"
#include "generator/cli/commands.hpp"
#include "generator/cli/method.hpp"
#include "generator/cli/output_times.hpp"
#include "generator/cli/run_checkpoints.hpp"
#include "generator/cli/run_files.hpp"
#include "generator/cli/run_frequencies.hpp"
#include "generator/cli/run_monitors.hpp"
#include "generator/cli/run_notes.hpp"
#include "generator/cli/run_picture.hpp"
#include "generator/cli/run_summary.hpp"
#include "generator/cli/run_wishes.hpp"
#include "generator/cli/runner.hpp"
#include "generator/drive/row_file.hpp"
#include "generator/emit/text/names.hpp"
#include "generator/hamiltonian/canonical.hpp"
#include "generator/hamiltonian/time_scale.hpp"
#include "generator/interpret/event_program.hpp"
#include "generator/simulate/simulation.hpp"
#include "generator/support/bar.hpp"
#include "generator/support/output_file.hpp"
#include "generator/support/pace.hpp"
#include "generator/support/process.hpp"
#include "generator/support/warning.hpp"
#include "generator/symmetry/watched.hpp"

namespace hvi::gen {

namespace {

namespace fs = std::filesystem;

constexpr std::int64_t most_rows = 10000;

/// `kepler-gauss_4`.
fs::path default_directory(const RunSubject& subject) {
    const std::string header = file_name(subject.method);
    return subject.scene + "-" + header.substr(0, header.rfind('.'));
}

std::optional<fs::path> directory(const RunSubject& subject, const RunOptions& options) {
    if (options.output) return options.output;
    if (options.files.contains(RunFile::table) || options.files.contains(RunFile::picture))
        return default_directory(subject);
    return {};
}

/// Wishes for a run: its tables and events, and how it is taken.
TrajectoryWishes trajectory(const WishedRun& wished, const RunOptions& options,
                            const RunTables& tables, const fs::path& table_of_events,
                            std::vector<ColumnBox> analysed) {
    TrajectoryWishes wishes{.h = wished.steps.size,
                            .steps = wished.steps.count,
                            .tables = {tables.own},
                            .events = wished.events,
                            .clock = wished.clock,
                            .reductions = wished.reductions,
                            .analysed = std::move(analysed)};
    if (tables.of_picture) wishes.tables.push_back(tables.of_picture->table);
    if (tables.plain) wishes.tables.push_back(*tables.plain);
    wishes.events.file = table_of_events;
    if (!options.checkpoints.any()) return wishes;
    const std::string key = key_of(wished, tables.own);
    wishes.checkpoints = wished_checkpoints(options.checkpoints, key);
    wishes.resumed = resumed_checkpoint(options.checkpoints, key);
    return wishes;
}

Simulation simulate(const Target& program, const TrajectoryWishes& wishes,
                    const WishedRun& wished) {
    Bar bar;
    Pace pace(wished.clock ? wished.clock->until : static_cast<double>(wished.steps.count),
              wished.clock ? "units of time" : "steps");
    return run_simulation(program, wished.subject, wishes,
                          [&](double part) { bar.show(part, pace.at(part, Pace::Clock::now())); });
}

std::vector<ColumnBox> columns_of(const RunSubject& subject, const Given& list) {
    const std::vector<NameBox> names = column_names(subject);
    return list ? named_columns(list, names, subject.sizes)
                : usual_columns(names, subject.coordinates.size() + subject.momenta.size());
}

/// Steps, and the end of the time where they are no times.
struct RunLength {
    Steps steps;
    std::optional<ScaledClock> clock = {};

    [[nodiscard]] double end() const {
        return clock ? clock->until : static_cast<double>(steps.count) * steps.size;
    }
};

/// Steps in scaled time, as many as it takes.
RunLength scaled_length(double size, double end) {
    constexpr std::int64_t most = 1'000'000'000'000'000;
    return {{size, most}, ScaledClock{end}};
}

RunLength scaled_length(const SceneTimes& times, const NamedExpression& step,
                        const NamedExpression& until) {
    const double size = nearest_value(times, step), end = nearest_value(times, until);
    if (size == 0) throw MathError("the step has the size 0", step.place);
    if (size * end < 0)
        throw MathError("steps of this size lead away from the end of the run", step.place,
                        "step and until have the same sign");
    return scaled_length(size, end);
}

RunLength wished_length(const Scene& scene, const RunOptions& options) {
    const SceneTimes times = times_of(scene);
    const NamedExpression step = wish(times, options.step, times.step, "step"),
                          until = wish(times, options.until, times.until, "until");
    if (scene.scale) return scaled_length(times, step, until);
    return {steps_to_output(steps_until(times, step, until), options.times)};
}

/// NOTE: what is interpreted computes one number after the other.
StepperWishes wishes_of(const RunOptions& options, bool interprets) {
    StepperWishes wishes = simulation_wishes(options.wishes.solver, options.wishes.composition);
    wishes.sweeps = options.wishes.sweeps;
    wishes.lanes = options.wishes.lanes;
    if (interprets) wishes.lanes = {Lanes::none};
    wishes.unroll = options.wishes.unroll;
    return wishes;
}

/// Symmetries, where they are asked for, whose momentum maps are added to the scene.
Watched watch(Scene& scene, const RunOptions& options) {
    if (!options.symmetries) return {};
    Watched watched = watch(scene, options.system.sums);
    if (!watched.left_out.empty())
        watched.left_out +=
            fmt::format("; `hvi-gen symmetries {}` looks for them", options.system.scene->text);
    return watched;
}

/// All coordinates and momenta, one by one. Precondition: they are written out.
std::vector<ColumnBox> all_variables(const RunSubject& subject) {
    std::vector<ColumnBox> columns;
    for (const std::vector<NameBox>* boxes : {&subject.coordinates, &subject.momenta})
        for (const NameBox& box : *boxes)
            columns.push_back({box, columns.size(), std::vector<std::size_t>(box.ranges.size())});
    return columns;
}

/// Columns of the table that are coordinates or momenta.
std::vector<ColumnBox> variables_in_table(const RunSubject& subject, const Given& list) {
    std::vector<ColumnBox> columns = columns_of(subject, list);
    std::vector<NameBox> all = subject.coordinates;
    all.insert(all.end(), subject.momenta.begin(), subject.momenta.end());
    std::erase_if(columns,
                  [&](const ColumnBox& column) { return name_at(all, column.number).empty(); });
    return columns;
}

/// Throws InputError where a jump is said to be symplectic, and is not.
void check_claim(const WrittenOutScene& scene, const SceneEvent& event) {
    if (!event.canonical) return;
    const auto* H = std::get_if<Hamiltonian>(&scene.mechanics);
    if (H == nullptr || !H->rotations.empty())
        throw InputError("this is not built for a Lagrangian and for rotations", event.canonical);
    const CanonicalFinding found = canonical(*H, scene.parameters, event);
    if (found.holds == Vanishing::refuted)
        throw InputError("the motion with this jump is not symplectic: " + found.fault,
                         event.canonical, "docs/events.md says what a jump has to keep");
    if (found.holds == Vanishing::unknown)
        warn("it is not seen whether the motion with the jump of `" + event.name +
             "` is symplectic: " + found.fault);
}

/// The events of a scene whose sums stay loops.
EventWishes events_of_loops(const Scene& scene, const RunSubject& subject, const Given& columns) {
    const auto refuse = [](const std::string& what, const Place& place) {
        throw InputError(what + " where sums stay loops", place,
                         "--unroll yes writes the sums out, up to 256 degrees of freedom");
    };
    if (scene.kinks) refuse("steps that end at kinks are not built", *scene.kinks);
    for (const IndexedEvent& event : scene.events)
        if (event.canonical) refuse("no jump is proved to be symplectic", *event.canonical);
    return {driven_events(scene), variables_in_table(subject, columns), {}};
}

/// The events of a scene, for a run.
EventWishes events_of(const Scene& scene, const SceneStepper& stepper, const RunSubject& subject,
                      const Given& columns) {
    if (scene.events.empty() && !scene.kinks) return {};
    if (!stepper.system.is_written_out()) return events_of_loops(scene, subject, columns);
    const WrittenOutScene written = unrolled(scene);
    for (const SceneEvent& event : written.events) check_claim(written, event);
    return {driven_events(stepper.system, with_time_scale(written)), all_variables(subject), {}};
}

/// With the momentum maps that are found.
WishedRun watched_run(MethodAndScene both, const StepperWishes& wishes, const RunLength& length,
                      const RunOptions& options, const Runner& runner) {
    const Watched watched = watch(both.scene, options);
    SceneStepper stepper = scene_stepper(both.method, both.scene, wishes);
    RunSubject subject = run_subject(stepper);
    KeepingFacts facts = keeping_facts(stepper.method.base);
    if (stepper.system.parts && watched.found)
        facts.parts = kept_by_parts(*stepper.system.parts, unrolled(both.scene), *watched.found);
    std::vector<Statement> statements = watched.statements(facts);
    EventWishes events = events_of(both.scene, stepper, subject, options.columns);
    Monitors monitors = wished_monitors(both, stepper, wishes, options, runner);
    std::string events_text = text_of(both.scene.events) + (both.scene.kinks ? "kinks\n" : "");
    std::vector<double> times;
    if (options.times)
        times = values_of(*options.times, times_of(both.scene), length.steps.size, length.end());
    std::optional<SectionAxes> section;
    if (stepper.system.is_written_out()) section = section_axes(unrolled(both.scene), subject);
    std::vector<Reduction> reductions;
    if (options.reduce)
        reductions = named_reductions(options.reduce, column_names(subject), subject.sizes);
    std::vector<TableNote> notes = notes_on(both.scene, stepper, subject, length.steps.size);
    return {std::move(stepper),
            std::move(subject),
            length.steps,
            std::move(monitors),
            length.clock,
            std::move(events),
            std::move(events_text),
            std::move(section),
            std::move(times),
            std::move(notes),
            std::move(reductions),
            std::move(statements),
            watched.left_out,
            options.accuracy
                ? "a smaller E of --accuracy"
                : "a smaller --step; or in its place --accuracy 1e-6, which finds a method and "
                  "a step"};
}

WishedRun advised_run(const RunOptions& options, const Runner& runner) {
    const AdvisedOptions advice = [&] {
        const InterruptionsHeld held;
        return advised({options.method.parameters, options.system, options.until, *options.accuracy,
                        options.budget});
    }();
    MethodOptions method_options = options.method;
    method_options.name = given("--method", advice.method);
    StepperWishes wishes = simulation_wishes(advice.solver, advice.composition);
    wishes.sweeps.choice = advice.sweeps;
    wishes.unroll = options.wishes.unroll;
    MethodAndScene both = read_scene(method_options, options.system);
    const RunLength length = both.scene.scale
                                 ? scaled_length(advice.steps.size, advice.until)
                                 : RunLength{steps_to_output(advice.steps, options.times)};
    WishedRun run = watched_run(std::move(both), wishes, length, options, runner);
    run.shortfall = advice.shortfall;
    return run;
}

WishedRun any_run(const RunOptions& options, const Runner& runner) {
    if (options.accuracy) return advised_run(options, runner);
    MethodAndScene both = read_scene(options.method, options.system);
    const RunLength length = wished_length(both.scene, options);
    return watched_run(std::move(both), wishes_of(options, runner.interprets()), length, options,
                       runner);
}

/// NOTE: the picture shows the columns that were asked for, where some were.
RunTables wished_tables(const WishedRun& wished, const RunOptions& options,
                        const std::vector<ColumnBox>& columns, RunFiles& files) {
    const std::int64_t usual = (wished.steps.count + most_rows - 1) / most_rows;
    const std::int64_t every =
        options.every.value_or(wished.clock ? 1 : std::max<std::int64_t>(1, usual));
    const TableFormat format = files.any() ? options.format : TableFormat::csv;
    RunTables tables{{every, columns, files.table(), wished.times, format, options.numbers,
                      wished.notes, meanings_of(wished.subject)},
                     {}};
    if (!options.files.contains(RunFile::picture) || options.checkpoints.any()) return tables;
    if (!options.columns && !wished.clock)
        tables.of_picture = picture_table(wished.subject.coordinates, wished.steps, every);
    if (tables.of_picture) {
        tables.of_picture->table.file = files.table_of_picture();
    } else if (options.format != TableFormat::csv) {
        tables.plain = {every, columns, files.table_of_picture(), wished.times};
    }
    return tables;
}

}  // namespace

void run(const RunOptions& options) {
    // NOTE: what is computed exactly an interruption may end at once, as there is nothing to clear
    // away.
    check_format(options.format);
    Runner runner(options.interpret);
    const WishedRun wished = any_run(options, runner);
    const RunSubject& subject = wished.subject;
    const Steps& steps = wished.steps;
    if (!wished.not_looked_for.empty())
        std::fputs(
            fmt::format("note: symmetries are not looked for: {}\n", wished.not_looked_for).c_str(),
            stderr);
    const InterruptionsHeld held;
    const std::vector<ColumnBox> columns = columns_of(subject, options.columns);
    std::vector<ColumnBox> analysed = analysed_columns(wished, options);
    note_left_out(steps);

    runner.begin(wished.stepper);
    begin(wished.monitors, runner);
    const Target target = runner.target(wished.stepper);
    const std::optional<fs::path> directory = hvi::gen::directory(subject, options);
    RunFiles files(directory);
    if (options.checkpoints.any())
        files.keep_growing(bool(options.checkpoints.resume), options.format);
    const RunTables tables = wished_tables(wished, options, columns, files);
    const fs::path events = wished.events.has_rows() ? files.events() : fs::path();
    const Simulation simulation =
        simulate(target, trajectory(wished, options, tables, events, std::move(analysed)), wished);
    if (simulation.status == interrupted_run) {  // as soon as this is left, the program ends
        if (options.files.contains(RunFile::table)) files.keep_table(simulation, options.format);
        return;
    }
    const MonitorFindings found =
        measured(wished.monitors, simulation, wished.events, steps.size, runner);
    const std::string summary = hvi::gen::summary(wished, simulation, found);
    if (options.files.contains(RunFile::table)) {
        files.keep_tangent(found.directions.entries);
        files.keep_sensitivities(
            table_of_sensitivities(wished.monitors, found, column_names(subject)));
        files.keep_section_map(section_table(found.directions, column_names(subject)));
        files.keep_frequencies(simulation.frequencies);
    }
    files.keep(subject, steps, simulation, tables, options.files, summary);
    if (wished.section && options.files.contains(RunFile::table) &&
        options.files.contains(RunFile::picture))
        files.keep_section(section_of("events of " + subject.scene + ", " + subject.method,
                                      *wished.section, wished.events, simulation));
    if (!simulation.ok())
        throw MathError(
            fmt::format("the run stopped after {}: {}", what_was_done(wished, simulation),
                        simulation.unfit.empty()
                            ? simulation.status
                            : simulation.unfit + " begins with no finite number"),
            {}, directory ? fmt::format("what there is of it is in {}", directory->string()) : "");
    warn_of_energy(simulation, wished);
    if (const std::string fault = found.fault(); !fault.empty()) throw MathError(fault);
    // NOTE: as a run that stopped early: what was asked for is not there, and what is there is
    // kept.
    if (!wished.shortfall.empty())
        throw MathError(wished.shortfall, {},
                        (directory ? fmt::format("the run of these is in {}; ", directory->string())
                                   : std::string()) +
                            "ask for less, for an earlier end by --until, or for more by --budget");
    if (options.files.contains(RunFile::summary)) write_standard_output(summary);
}

}  // namespace hvi::gen
