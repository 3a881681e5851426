// `hvi-gen run`: a scene, integrated from its initial data.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <system_error>

#include "generator/cli/advice.hpp"
#include "generator/cli/commands.hpp"
#include "generator/cli/method.hpp"
#include "generator/cli/run_picture.hpp"
#include "generator/cli/run_wishes.hpp"
#include "generator/emit/text/names.hpp"
#include "generator/interpret/interpretation.hpp"
#include "generator/program/builds.hpp"
#include "generator/render/statements.hpp"
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
constexpr const char* table_name = "trajectory.csv";
constexpr const char* picture_name = "picture.svg";
constexpr const char* summary_name = "summary.txt";

/// `kepler-gauss_4`.
fs::path default_directory(const RunSubject& subject) {
    const std::string header = file_name(subject.method);
    return subject.scene + "-" + header.substr(0, header.rfind('.'));
}

/// A file that a program of ours fills. Removed at the end of its life unless renamed.
class Unfinished {
public:
    explicit Unfinished(const fs::path& directory) : path_(new_file(directory)) {}
    ~Unfinished() {
        std::error_code ignored;
        fs::remove(path_, ignored);
    }
    Unfinished(const Unfinished&) = delete;
    Unfinished& operator=(const Unfinished&) = delete;

    [[nodiscard]] const fs::path& path() const { return path_; }

    void rename_to(const fs::path& target) {
        std::error_code error;
        fs::rename(path_, target, error);
        if (error)
            throw EnvironmentError("cannot write " + target.string() + ": " + error.message());
    }

private:
    fs::path path_;
};

/// What is to be run, and the steps that it is to take.
struct WishedRun {
    SceneStepper stepper;
    RunSubject subject;
    Steps steps;
    std::vector<Statement> statements = {};  ///< of what it keeps
    std::string not_looked_for = {};         ///< symmetries: why, and what looks for them
    std::string help_on_steps = {};          ///< that are too large
    std::string shortfall = {};              ///< of the accuracy; empty where it is reached
};

double per_step(std::int64_t count, std::int64_t steps) {
    return static_cast<double>(count) / static_cast<double>(steps);
}

/// The part of the time at the end in which there is no whole step.
std::string left_out(const Steps& asked) {
    const double last = static_cast<double>(asked.count) * asked.size;
    return fmt::format("t = {:.10g} to {:.10g}, which is less than a step", last,
                       last + asked.left);
}

void note_left_out(const Steps& asked) {
    if (asked.left == 0) return;
    std::fputs(fmt::format("note: {}left out is {} of {:.10g}\n",
                           asked.count == 0 ? "no step is made; " : "", left_out(asked), asked.size)
                   .c_str(),
               stderr);
}

/// The start of a quantity, its measured errors, and what is known of it beside them. NOTE: what is
/// not conserved at all energies may be at that of the run, so its changes are no errors.
std::string said_of(const Conserved& kept, const std::vector<Statement>& statements) {
    const auto statement =
        std::find_if(statements.begin(), statements.end(),
                     [&](const Statement& each) { return each.name == kept.name; });
    const bool is_known = statement != statements.end() && statement->keeping != Keeping::unknown;
    if (is_known && statement->keeping == Keeping::not_conserved)
        return fmt::format(
            "{:.10g}; {}; on this run {} changed by {:.2e} at most, {:.2e} at the end", kept.start,
            statement->reason, kept.name, kept.largest, kept.last);
    return fmt::format("{:.10g}, largest error {:.2e}, at the end {:.2e}{}", kept.start,
                       kept.largest, kept.last,
                       is_known ? fmt::format("; {}", keeping_text(statement->keeping)) : "");
}

std::string summary(const WishedRun& wished, const Simulation& run) {
    const RunSubject& subject = wished.subject;
    const Steps& asked = wished.steps;
    std::size_t width = std::string_view("evaluations").size();
    for (const Conserved& kept : run.conserved) width = std::max(width, kept.name.size());
    std::string text;
    const auto line = [&](const std::string& name, const std::string& value) {
        text += fmt::format("{:<{}}  {}\n", name, width, value);
    };
    line("scene", subject.scene + (subject.description.empty() ? "" : ": " + subject.description));
    line("method", subject.title);
    line("steps", fmt::format("{} of {}, until t = {:.10g}", run.steps, asked.size,
                              static_cast<double>(run.steps) * asked.size));
    if (asked.left != 0) line("left out", left_out(asked));
    if (!run.ok())
        line("incomplete", fmt::format("{} steps were wanted: {}", asked.count, run.status));
    if (!wished.shortfall.empty()) line("accuracy", wished.shortfall);
    if (run.steps > 0) {
        line("time", fmt::format("{} a step, {} in all", duration(run.seconds_of_step),
                                 duration(run.seconds_of_step * static_cast<double>(run.steps))));
        line("evaluations",
             fmt::format("{:.2f} of d{}/dq a step, {} in all", per_step(run.evaluations, run.steps),
                         subject.function_letter, run.evaluations));
        if (run.iterations > 0)
            line("iterations", fmt::format("{:.2f} a step", per_step(run.iterations, run.steps)));
    }
    for (const Conserved& kept : run.conserved) line(kept.name, said_of(kept, wished.statements));
    if (!wished.not_looked_for.empty())
        line("symmetries", "not looked for: " + wished.not_looked_for);
    return text;
}

/// Warns where the energy changes by more than a tenth of its scale. That is the larger of |H| at
/// the start and of the mean size of H(q, p) - H(q, 0) on the way: H may be 0 at the start, as it
/// is up to a constant. NOTE: not how much of it there is at the start, or at most. On an ellipse
/// of the eccentricity 0.9999 that is 20 000 times H where it is near the sun, and the mean is -H.
void warn_of_energy(const Simulation& run, const WishedRun& wished) {
    constexpr double much = 0.1;
    for (const Conserved& kept : run.conserved) {
        if (kept.name != "energy") continue;
        const double scale = std::max(std::abs(kept.start), run.energy_of_motion);
        if (scale == 0 || !(kept.largest > much * scale)) return;
        warn(
            fmt::format("the energy changes by {:.2g}, of a scale of {:.2g}: the step is too large",
                        kept.largest, scale),
            wished.help_on_steps);
    }
}

/// Says in the table itself that it is not whole.
void mark_incomplete(const fs::path& table, const Simulation& run) {
    std::FILE* file = std::fopen(table.c_str(), "ab");
    const bool written =
        file != nullptr && std::fprintf(file, "# incomplete: %s\n", run.status.c_str()) > 0;
    if (file == nullptr || std::fclose(file) != 0 || !written)
        throw EnvironmentError("cannot write " + table.string());
}

/// A directory for results; where nothing was left in it, at the end of its life it is gone again.
class ResultDirectory {
public:
    explicit ResultDirectory(fs::path path) : path_(std::move(path)) {
        std::error_code ignored;
        for (fs::path each = path_; !each.empty() && !fs::exists(each, ignored);
             each = each.parent_path())
            missing_.push_back(each);
        make_directory(path_);
    }
    ~ResultDirectory() {
        std::error_code ignored;
        for (const fs::path& each : missing_)
            if (fs::is_empty(each, ignored)) fs::remove(each, ignored);
    }
    ResultDirectory(const ResultDirectory&) = delete;
    ResultDirectory& operator=(const ResultDirectory&) = delete;

    [[nodiscard]] const fs::path& path() const { return path_; }

private:
    fs::path path_;
    std::vector<fs::path> missing_;  ///< before; the innermost first
};

/// Files that a run leaves, all of them whole. Without a directory there are none.
class Results {
public:
    explicit Results(const std::optional<fs::path>& directory) {
        if (!directory) return;
        directory_.emplace(*directory);
        table_.emplace(*directory);
    }

    /// Where the table grows.
    [[nodiscard]] fs::path table() const { return table_ ? table_->path() : "/dev/null"; }

    /// Where a table of the picture grows. Precondition: there is a directory.
    [[nodiscard]] fs::path table_of_picture() {
        return table_of_picture_.emplace(directory_->path()).path();
    }

    void keep(const RunSubject& subject, const Steps& asked, const Simulation& run,
              RunTables tables, const RunOptions& options, const std::string& summary) {
        if (!directory_) return;
        const auto leaves = [&](RunFile file) { return options.files.contains(file); };
        if (!run.ok()) mark_incomplete(table_->path(), run);
        if (leaves(RunFile::table)) {
            tables.own.file = directory_->path() / table_name;
            table_->rename_to(tables.own.file);
        }
        if (leaves(RunFile::summary)) write_file(directory_->path() / summary_name, summary);
        if (leaves(RunFile::picture))
            write_file(directory_->path() / picture_name,
                       draw(picture(subject, asked, run, tables)));
    }

private:
    std::optional<ResultDirectory> directory_;
    std::optional<Unfinished> table_, table_of_picture_;  // below: they are in the directory
};

std::optional<fs::path> directory(const RunSubject& subject, const RunOptions& options) {
    if (options.output) return options.output;
    if (options.files.contains(RunFile::table) || options.files.contains(RunFile::picture))
        return default_directory(subject);
    return {};
}

Simulation simulate(const Target& program, const RunSubject& subject, const Steps& steps,
                    const RunTables& tables) {
    Bar bar;
    Pace pace(static_cast<double>(steps.count), "steps");
    TrajectoryWishes wishes{.h = steps.size, .steps = steps.count, .tables = {tables.own}};
    if (tables.of_picture) wishes.tables.push_back(tables.of_picture->table);
    return run_simulation(program, subject, wishes,
                          [&](double part) { bar.show(part, pace.at(part, Pace::Clock::now())); });
}

std::vector<ColumnBox> columns_of(const RunSubject& subject, const Given& list) {
    const std::vector<NameBox> names = column_names(subject);
    return list ? named_columns(list, names, subject.sizes)
                : usual_columns(names, subject.coordinates.size() + subject.momenta.size());
}

Steps wished_steps(const Scene& scene, const RunOptions& options) {
    const SceneTimes times = times_of(scene);
    return steps_until(times, wish(times, options.step, times.step, "step"),
                       wish(times, options.until, times.until, "until"));
}

/// NOTE: what is interpreted computes one number after the other.
StepperWishes wishes_of(const RunOptions& options, bool interprets) {
    StepperWishes wishes = simulation_wishes(options.wishes.solver, options.wishes.composition);
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

/// With the momentum maps that are found.
WishedRun watched_run(MethodAndScene both, const StepperWishes& wishes, const Steps& steps,
                      const RunOptions& options) {
    const Watched watched = watch(both.scene, options);
    SceneStepper stepper = scene_stepper(both.method, both.scene, wishes);
    RunSubject subject = run_subject(stepper);
    std::vector<Statement> statements = watched.statements(keeping_facts(stepper.method.base));
    return {std::move(stepper),
            std::move(subject),
            steps,
            std::move(statements),
            watched.left_out,
            options.accuracy
                ? "a smaller E of --accuracy"
                : "a smaller --step; or in its place --accuracy 1e-6, which finds a method and "
                  "a step"};
}

WishedRun advised_run(const RunOptions& options) {
    const AdvisedOptions advice = [&] {
        const InterruptionsHeld held;
        return advised({options.method.parameters, options.system, options.until, *options.accuracy,
                        options.budget});
    }();
    MethodOptions method_options = options.method;
    method_options.name = given("--method", advice.method);
    StepperWishes wishes = simulation_wishes(advice.solver, advice.composition);
    wishes.unroll = options.wishes.unroll;
    WishedRun run =
        watched_run(read_scene(method_options, options.system), wishes, advice.steps, options);
    run.shortfall = advice.shortfall;
    return run;
}

WishedRun any_run(const RunOptions& options, bool interprets) {
    if (options.accuracy) return advised_run(options);
    MethodAndScene both = read_scene(options.method, options.system);
    const Steps steps = wished_steps(both.scene, options);
    return watched_run(std::move(both), wishes_of(options, interprets), steps, options);
}

/// NOTE: the picture shows the columns that were asked for, where some were.
RunTables wished_tables(const RunSubject& subject, const Steps& steps, const RunOptions& options,
                        const std::vector<ColumnBox>& columns, Results& results) {
    const std::int64_t every = std::max<std::int64_t>(1, (steps.count + most_rows - 1) / most_rows);
    RunTables tables{{every, columns, results.table()}, {}};
    if (options.files.contains(RunFile::picture) && !options.columns)
        tables.of_picture = picture_table(subject.coordinates, steps, every);
    if (tables.of_picture) tables.of_picture->table.file = results.table_of_picture();
    return tables;
}

/// What takes the steps: a compiled module, or hvi-gen itself.
class Runner {
public:
    /// Looks for a compiler where none is to be done without.
    explicit Runner(const std::optional<Place>& interpret) : interpret_(interpret) {
        if (interpret) return;
        try {
            compiler_ = find_compiler();
        } catch (const EnvironmentError& error) { missing_ = error; }
    }

    [[nodiscard]] bool interprets() const { return !compiler_.has_value(); }

    /// Throws InputError where steps cannot be interpreted, or EnvironmentError where they had to
    /// be for want of a compiler. Precondition: it lives longer.
    [[nodiscard]] Target target(const SceneStepper& stepper) {
        if (compiler_) {
            builds_.emplace(*compiler_);
            return simulation_program(stepper).order(*builds_).target();
        }
        const std::string obstacle = obstacle_to_interpretation(stepper);
        if (!obstacle.empty() && missing_) throw *missing_;
        if (!obstacle.empty())
            throw InputError("this cannot be run without a compiler: " + obstacle, interpret_,
                             "what can be is in docs/interpreter.md");
        if (missing_)
            std::fputs(fmt::format("note: {}; steps are interpreted\n", missing_->what()).c_str(),
                       stderr);
        return Interpreted{interpretation(stepper)};
    }

private:
    std::optional<Place> interpret_;
    std::optional<Compiler> compiler_;
    std::optional<EnvironmentError> missing_;
    std::optional<Builds> builds_;
};

}  // namespace

void run(const RunOptions& options) {
    // NOTE: what is computed exactly an interruption may end at once, as there is nothing to clear
    // away.
    Runner runner(options.interpret);
    const WishedRun wished = any_run(options, runner.interprets());
    const RunSubject& subject = wished.subject;
    const Steps& steps = wished.steps;
    if (!wished.not_looked_for.empty())
        std::fputs(
            fmt::format("note: symmetries are not looked for: {}\n", wished.not_looked_for).c_str(),
            stderr);
    const InterruptionsHeld held;
    const std::vector<ColumnBox> columns = columns_of(subject, options.columns);
    note_left_out(steps);

    const Target target = runner.target(wished.stepper);
    const std::optional<fs::path> directory = hvi::gen::directory(subject, options);
    Results results(directory);
    const RunTables tables = wished_tables(subject, steps, options, columns, results);
    const Simulation simulation = simulate(target, subject, steps, tables);
    const std::string summary = hvi::gen::summary(wished, simulation);
    results.keep(subject, steps, simulation, tables, options, summary);
    if (!simulation.ok())
        throw MathError(
            fmt::format("the run stopped after {} of {} steps: {}", simulation.steps, steps.count,
                        simulation.unfit.empty()
                            ? simulation.status
                            : simulation.unfit + " begins with no finite number"),
            {}, directory ? fmt::format("what there is of it is in {}", directory->string()) : "");
    warn_of_energy(simulation, wished);
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
