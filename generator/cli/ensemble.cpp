// `hvi-gen ensemble`: many trajectories of a scene, as a study.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <thread>
#include <utility>

#include "generator/cli/commands.hpp"
#include "generator/cli/ensemble_results.hpp"
#include "generator/cli/ensemble_steppers.hpp"
#include "generator/cli/ensemble_work.hpp"
#include "generator/cli/method.hpp"
#include "generator/cli/output_times.hpp"
#include "generator/cli/run_wishes.hpp"
#include "generator/emit/text/names.hpp"
#include "generator/ensembles/slurm.hpp"
#include "generator/support/digest.hpp"
#include "generator/support/output_file.hpp"
#include "generator/support/process.hpp"
#include "generator/support/shell_word.hpp"
#include "generator/support/version.hpp"

namespace hvi::gen {

namespace {

namespace fs = std::filesystem;

RowSources sources_of(const EnsembleOptions& options, const SceneTimes& times) {
    RowSources sources{.file = options.initial,
                       .grids = {},
                       .laws = {},
                       .samples = options.samples,
                       .seed = static_cast<std::uint64_t>(options.seed)};
    for (const Given& text : options.vary) sources.grids.push_back(grid(text, times));
    for (const Given& text : options.random) sources.laws.push_back(law(text, times));
    return sources;
}

using NamedNumbers = std::vector<std::pair<std::string, std::size_t>>;

NamedNumbers named_numbers(const std::vector<ColumnBox>& columns) {
    NamedNumbers result;
    for_each_column(columns, [&](const std::string& name, std::size_t number) {
        result.emplace_back(name, number);
    });
    return result;
}

/// Columns of the state at the end of a row.
NamedNumbers state_of(const RunSubject& subject) {
    std::vector<NameBox> variables = subject.coordinates;
    variables.insert(variables.end(), subject.momenta.begin(), subject.momenta.end());
    return named_numbers(usual_columns(variables, variables.size()));
}

/// Columns that are asked for and are not among those of the state.
NamedNumbers asked_columns(const RunSubject& subject, const Given& list,
                           const NamedNumbers& state) {
    if (!list) return {};
    NamedNumbers asked = named_numbers(named_columns(list, column_names(subject), subject.sizes));
    std::erase_if(asked, [&](const auto& column) {
        return std::find(state.begin(), state.end(), column) != state.end();
    });
    return asked;
}

/// Names of the columns of a study, in the order in which StudyRows writes them.
std::vector<std::string> column_names_of(const EnsembleWork& work, const NamedNumbers& state,
                                         const NamedNumbers& asked) {
    std::vector<std::string> names{"row"};
    for (const std::string& name : work.plan.columns()) names.push_back(name);
    for (const auto& column : state) names.push_back(column.first);
    names.insert(names.end(), {"t", status_column, "steps"});
    if (work.has_energy()) names.emplace_back("energy_error");
    for (const std::string& event : work.events()) names.push_back("count(" + event + ")");
    for (const auto& column : asked) names.push_back(column.first);
    for (const Reduction& each : work.wishes.reductions) names.push_back(each.name);
    if (work.wishes.growth) names.insert(names.end(), {"lyapunov", "megno"});
    return names;
}

std::string command_of(const EnsembleOptions& options) {
    std::string command = "hvi-gen";
    for (const std::string& word : options.words) command += " " + shell_word(word);
    return command;
}

/// Identifies all that rows depend on. NOTE: a machine's compiler may fuse products and sums, so
/// that bits of rows are those of one kind of machine.
std::string key_of(const EnsembleOptions& options, const EnsembleWork& work,
                   const std::vector<std::string>& columns, const RowSource& source) {
    std::string text = fmt::format("{}\n{}\n{}\n", version, work.stepper.header, source.key());
    for (const OwnHeader& own : work.stepper.own_headers) text += own.text + "\n";
    if (work.at_once) text += work.at_once->stepper.header;
    text += options.interpret ? "interpreted\n" : "compiled\n";
    text += fmt::format("{}\n{}\n", work.scene.text, work.scene.origin);
    for (const Given& given : {options.step, options.until})
        text += given ? given->text + "\n" : "-\n";
    for (const Given& parameter : options.method.parameters) text += parameter->text + "\n";
    for (const std::string& column : columns) text += column + "\n";
    return digest(text);
}

/// NOTE: some 100 000 rows fill a large card.
std::int64_t rows_in_chunk(const EnsembleOptions& options, const EnsembleWork& work,
                           std::int64_t rows) {
    constexpr std::int64_t chunks = 256, most = 10000, side_by_side = 32, on_device = 1 << 17;
    if (options.chunk) return *options.chunk;
    if (work.are_on_device()) return on_device;
    const std::int64_t fewest = work.at_once ? side_by_side : 1;
    return std::clamp((rows + chunks - 1) / chunks, fewest, most);
}

fs::path directory_of(const EnsembleOptions& options, const RunSubject& subject) {
    if (options.output) return *options.output;
    const std::string header = file_name(subject.method);
    return subject.scene + "-" + header.substr(0, header.rfind('.')) + "-study";
}

/// Throws InputError where --param gives a value to what rows differ in.
void check_parameters(const MethodAndScene& both, const std::vector<VariedName>& names) {
    for (const Parameter& parameter : both.values)
        for (const VariedName& name : names)
            if (name.name == parameter.name)
                throw InputError(fmt::format("`{}` has a value for all rows by --param", name.name),
                                 name.place, "leave one of them out");
}

std::size_t workers_of(const EnsembleOptions& options) {
    if (options.workers) return static_cast<std::size_t>(*options.workers);
    if (options.cuda) return 1;
    return std::max(1U, std::thread::hardware_concurrency());
}

/// A study as it is asked for.
struct AskedStudy {
    RowSource source;
    EnsembleWork work;
    Study study;
};

AskedStudy asked_study(const EnsembleOptions& options) {
    const MethodAndScene both = read_scene(options.method, options.system);
    const SceneTimes times = times_of(both.scene);
    RowSource source(sources_of(options, times));
    check_parameters(both, source.names());
    EnsembleWork work = work_of(options, both, source, times);
    const RunSubject subject = run_subject(work.stepper);
    const NamedNumbers state = state_of(subject),
                       asked = asked_columns(subject, options.columns, state);
    work.count_of_state = state.size();
    for (const NamedNumbers* columns : {&state, &asked})
        for (const auto& column : *columns) work.wishes.columns.push_back(column.second);
    if (options.reduce)
        work.wishes.reductions =
            named_reductions(options.reduce, column_names(subject), subject.sizes);
    Study study{.directory = directory_of(options, subject),
                .title = fmt::format("{}, {}", subject.scene, subject.title),
                .command = command_of(options),
                .key = "",
                .rows = source.count(),
                .rows_in_chunk = rows_in_chunk(options, work, source.count()),
                .columns = column_names_of(work, state, asked)};
    study.key = key_of(options, work, study.columns, source);
    check_map(study, options.map);
    return {std::move(source), std::move(work), std::move(study)};
}

}  // namespace

void run(const EnsembleOptions& options) {
    Runner runner(options.interpret);
    const AskedStudy asked = asked_study(options);
    const Study& study = asked.study;
    if (options.launcher == Launcher::slurm)
        return write_standard_output(slurm_script(study, options.words, *options.workers));

    const InterruptionsHeld held;
    if (options.launcher == Launcher::mpi)
        return compute_by_ranks(study, asked.work, asked.source, runner,
                                [&] { write_results(study, options); });
    begin(study);
    if (!compute(study, asked.work, asked.source, workers_of(options), runner))
        return;  // interrupted: as soon as this is left, the program ends
    write_results(study, options);
}

}  // namespace hvi::gen
