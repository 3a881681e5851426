// Interprets the words of the command line, after CLI11 has split them.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/options.hpp"

#include <algorithm>
#include <sstream>
#include <string_view>
#include <utility>

#include "generator/cli/grammar.hpp"
#include "generator/cli/rules.hpp"
#include "generator/cli/words.hpp"
#include "generator/pipeline/refusals.hpp"
#include "generator/read/nearest.hpp"
#include "generator/symmetry/symmetries.hpp"

namespace hvi::gen {

namespace {

using File = std::optional<std::filesystem::path>;

File output_option(const Words& words) {
    const Given file = words.file("--output");
    return file ? File(file->text) : std::nullopt;
}

/// Returns an empty method where none is given.
MethodOptions method_beside_scene(const Words& words) {
    MethodOptions method;
    method.name = words.value("--method");
    method.basis = words.value("--basis");
    method.nodes = words.value("--nodes");
    method.weights = words.value("--weights");
    method.file = words.value("--method-file");
    method.parameters = words.texts("--param");
    return method;
}

MethodOptions method_options(const Words& words, const CommandLine& line) {
    MethodOptions method = method_beside_scene(words);
    if (!method.name && !method.basis && !method.file)
        throw InputError("no method is given", line.end(), "for example --method gauss:2");
    return method;
}

/// Returns nothing where no system is named.
std::optional<SystemOptions> system_options(const Words& words) {
    SystemOptions system;
    system.scene = words.value("SCENE");
    system.hamiltonian = words.value("--hamiltonian");
    system.coordinates = words.value("--coordinates");
    system.momenta = words.value("--momenta");
    if (system.scene || system.hamiltonian) return system;
    return {};
}

/// Sets the member that a row of the table names to the value of the option.
struct WishReader {
    const Words& words;
    std::string_view option;
    StepperWishes& wishes;

    void operator()(std::monostate) const {}
    void operator()(bool StepperWishes::*member) const { wishes.*member = words.has(option); }
    void operator()(Solver StepperWishes::*member) const {
        if (const auto solver = words.choice<Solver>(option)) wishes.*member = *solver;
    }
    void operator()(Wish<int> StepperWishes::*member) const {
        if (const auto number = words.whole_number(option))
            wishes.*member = {*number, whole(words.value(option))};
    }
    void operator()(Unroll StepperWishes::*member) const {
        if (const auto unroll = words.choice<Unroll>(option)) wishes.*member = *unroll;
    }
    void operator()(Wish<Lanes> StepperWishes::*member) const {
        if (const auto lanes = words.choice<Lanes>(option))
            wishes.*member = {*lanes, whole(words.value(option))};
    }
    void operator()(std::optional<Composition> StepperWishes::*member) const {
        if (const Given name = words.value(option)) wishes.*member = named_composition(name);
    }
    void operator()(Given StepperWishes::*member) const { wishes.*member = words.value(option); }
};

/// Prefers loops for many coordinates: symmetries of families are found at once, however many
/// elements they have.
void prefer_loops(SystemOptions& system) { system.sums.most_degrees = most_degrees_of_symmetries; }

StepperWishes wishes_of(const Words& words) {
    StepperWishes wishes;
    for (const OptionEntry* option : options_of(words.command()))
        std::visit(WishReader{words, option->name, wishes}, option->wish);
    return wishes;
}

/// Sets the choices of a stepper that its scene is read with: sums, and parts of H.
void set_choices(SystemOptions& system, const StepperWishes& wishes, const Words& words) {
    system.sums = {wishes.unroll, wish_without_loops(wishes)};
    system.split = words.choice<SplitChoice>("--split");
}

TableauOptions tableau_options(const Words& words, const CommandLine& line) {
    TableauOptions options;
    options.method = method_options(words, line);
    options.format = words.choice<TableauFormat>("--format").value_or(options.format);
    options.digits = words.whole_number("--digits").value_or(options.digits);
    options.output = output_option(words);
    return options;
}

CheckOptions check_options(const Words& words, const CommandLine& line) {
    CheckOptions options;
    if (const Given file = words.file("--tableau")) options.tableau = file->text;
    options.method = options.tableau ? method_beside_scene(words) : method_options(words, line);
    if (const auto sweeps = words.whole_number("--sweeps"))
        options.sweeps = {*sweeps, whole(words.value("--sweeps"))};
    options.max_order = words.whole_number("--max-order").value_or(options.max_order);
    options.format = words.choice<CertificateFormat>("--format").value_or(options.format);
    options.system = system_options(words);
    if (options.system) prefer_loops(*options.system);
    options.symmetries = !words.has("--no-symmetries");
    options.plot = words.file("--plot");
    options.output = output_option(words);
    return options;
}

StepperOptions stepper_options(const Words& words, const CommandLine& line) {
    StepperOptions options;
    options.system = system_options(words);
    options.accuracy = words.fraction("--accuracy");
    if (const auto seconds = words.whole_number("--budget")) options.budget = *seconds;
    options.until = words.value("--until");
    options.method = options.system && options.system->scene ? method_beside_scene(words)
                                                             : method_options(words, line);
    options.wishes = wishes_of(words);
    if (options.system) set_choices(*options.system, options.wishes, words);
    options.explain = words.has("--explain");
    if (const auto stage = words.choice<Stage>("--dump")) {
        options.dump = Wish<Stage>{*stage, whole(words.value("--dump"))};
    }
    options.output = output_option(words);
    return options;
}

SystemOptions needed_system(const Words& words, const CommandLine& line) {
    const auto system = system_options(words);
    if (system) return *system;
    throw InputError("no Hamiltonian is given", line.end(),
                     "for example kepler, which `hvi-gen list scenes` shows, or --hamiltonian "
                     "\"p^2/2 + w^2*q^2/2\"");
}

SchemeOptions scheme_options(const Words& words, const CommandLine& line) {
    SchemeOptions options;
    options.method = method_options(words, line);
    options.system = needed_system(words, line);
    options.generating = words.has("--generating");
    options.lagrangian = words.has("--lagrangian");
    options.series = words.whole_number("--series");
    // NOTE: eight equations of each kind are read sooner than one with conditions.
    constexpr std::size_t most_degrees_in_words = 8;
    options.system.sums = {words.choice<Unroll>("--unroll").value_or(Unroll::automatic),
                           options.lagrangian   ? "--lagrangian"
                           : options.generating ? "--generating"
                           : options.series     ? "--series"
                                                : "",
                           most_degrees_in_words};
    options.format = words.choice<EquationsFormat>("--format").value_or(options.format);
    options.output = output_option(words);
    return options;
}

[[noreturn]] void refuse_without_scene(const CommandLine& line) {
    throw InputError("no scene is given", line.end(),
                     "for example kepler, which `hvi-gen list scenes` shows");
}

RunOptions run_options(const Words& words, const CommandLine& line) {
    RunOptions options;
    options.method = method_beside_scene(words);
    options.system.scene = words.value("SCENE");
    if (!options.system.scene) refuse_without_scene(line);
    options.wishes = wishes_of(words);
    set_choices(options.system, options.wishes, words);
    options.accuracy = words.fraction("--accuracy");
    if (const auto seconds = words.whole_number("--budget")) options.budget = *seconds;
    options.step = words.value("--step");
    options.until = words.value("--until");
    if (const Given times = words.value("--times")) {
        options.times = output_times(times);
        if (!options.until) options.until = options.times->to;
    }
    options.every = words.whole_number("--every");
    options.format = words.choice<TableFormat>("--format").value_or(TableFormat::csv);
    options.numbers = words.choice<TableNumbers>("--numbers").value_or(options.numbers);
    options.columns = words.value("--columns");
    options.reduce = words.value("--reduce");
    options.symmetries = !words.has("--no-symmetries");
    if (words.has("--interpret")) options.interpret = words.place("--interpret");
    options.checkpoints.file = words.file("--checkpoint");
    options.checkpoints.every = words.whole_number("--checkpoint-every");
    if (const auto minutes = words.whole_number("--checkpoint-minutes"))
        options.checkpoints.minutes = *minutes;
    options.checkpoints.resume = words.file("--resume");
    options.tangent = words.has("--tangent");
    options.sensitivity = words.value("--sensitivity");
    options.lyapunov = words.mode<Exponents>("--lyapunov");
    options.megno = words.has("--megno");
    options.sali = words.has("--sali");
    options.shadow = words.has("--shadow");
    options.frequencies = words.value("--frequencies");
    options.files = words.choices<RunFile>("--only");
    if (options.files.empty()) options.files = {RunFile::table, RunFile::picture, RunFile::summary};
    if (options.checkpoints.any() && options.format == TableFormat::hdf5)
        throw InputError("a table in HDF5 does not go with checkpoints",
                         whole(words.value("--format")),
                         "it cannot be read where the run is killed; --format npy can");
    if (options.reduce && !options.files.contains(RunFile::summary))
        throw InputError("what --reduce finds is said in the summary, which is left out",
                         whole(words.value("--only")), "add it, as in --only table,summary");
    // NOTE: a picture is drawn of rows as text, and a resumed run has only its own rows.
    if (options.checkpoints.any() && options.format != TableFormat::csv)
        options.files.erase(RunFile::picture);
    options.output = output_option(words);
    return options;
}

EnsembleOptions ensemble_options(const Words& words, const CommandLine& line) {
    EnsembleOptions options;
    options.method = method_beside_scene(words);
    options.system.scene = words.value("SCENE");
    if (!options.system.scene) refuse_without_scene(line);
    options.wishes = wishes_of(words);
    set_choices(options.system, options.wishes, words);
    options.step = words.value("--step");
    options.until = words.value("--until");
    options.columns = words.value("--columns");
    options.reduce = words.value("--reduce");
    options.megno = words.has("--megno");
    options.initial = words.file("--initial");
    options.vary = words.texts("--vary");
    options.random = words.texts("--random");
    options.samples = words.whole_number("--samples").value_or(options.samples);
    options.seed = words.whole_number("--seed").value_or(options.seed);
    options.chunk = words.whole_number("--chunk");
    if (words.has("--interpret")) options.interpret = words.place("--interpret");
    if (words.has("--cuda")) options.cuda = words.place("--cuda");
    options.workers = words.whole_number("--workers");
    if (const auto tasks = words.whole_number("--slurm")) {
        options.launcher = Launcher::slurm;
        options.workers = tasks;
    }
    if (words.has("--mpi")) options.launcher = Launcher::mpi;
    options.map = words.value("--map");
    options.output = output_option(words);
    options.words = line.words();
    if (!options.initial && options.vary.empty() && options.random.empty())
        throw InputError("no rows are asked for", line.end(),
                         "for example --vary \"NAME=0:1:11\", --random \"NAME=normal(0, 1)\" "
                         "--samples 100, or --initial starts.csv");
    return options;
}

CollectOptions collect_options(const Words& words, const CommandLine& line) {
    const Given directory = words.file("DIR");
    if (!directory)
        throw InputError("no study is given", line.end(),
                         "it is a directory that `hvi-gen ensemble` has made");
    return {directory->text, output_option(words)};
}

ModuleOptions module_options(const Words& words, const CommandLine& line) {
    ModuleOptions options;
    options.method = method_beside_scene(words);
    options.system.scene = words.value("SCENE");
    if (!options.system.scene) refuse_without_scene(line);
    options.wishes = wishes_of(words);
    set_choices(options.system, options.wishes, words);
    options.name = words.value("--name");
    options.language = words.choice<Language>("--language").value_or(Language::c);
    if (const auto directory = output_option(words)) options.output = *directory;
    return options;
}

bool is_file(ReportItem item) {
    using enum ReportItem;
    return item == html || item == json || item == csv || item == svg;
}

/// Returns the named files and parts of a report. No named file means all files; no named part
/// means work on scenes, and with --edges all parts at the edges.
std::set<ReportItem> items_of_report(const Words& words) {
    using enum ReportItem;
    const std::set<ReportItem> named = words.choices<ReportItem>("--only");
    std::set<ReportItem> items = named;
    if (std::none_of(named.begin(), named.end(), is_file)) items.insert({html, json, csv, svg});
    if (!std::all_of(named.begin(), named.end(), is_file)) return items;
    if (words.has("SCENE") || !words.has("--edges")) items.insert(work);
    if (words.has("--edges"))
        items.insert({rejections, symplecticity, stiff, extreme, long_runs, time});
    return items;
}

std::optional<Place> place_of_edges(const Words& words) {
    if (words.has("--edges")) return words.place("--edges");
    const std::set<ReportItem> named = words.choices<ReportItem>("--only");
    const bool is_named = std::any_of(named.begin(), named.end(), [](ReportItem item) {
        return !is_file(item) && item != ReportItem::work;
    });
    return is_named ? std::optional(whole(words.value("--only"))) : std::nullopt;
}

ReportOptions report_options(const Words& words, const CommandLine& line) {
    ReportOptions options;
    options.scenes = words.texts("SCENE");
    if (words.has("--peers")) options.peers = words.place("--peers");
    options.edges = place_of_edges(words);
    options.sums = {words.choice<Unroll>("--unroll").value_or(Unroll::automatic),
                    options.peers   ? "--peers"
                    : options.edges ? "what is measured at edges"
                                    : ""};
    options.symmetries = !words.has("--no-symmetries");
    options.method = method_beside_scene(words);
    options.methods = words.value("--methods");
    options.steps = words.value("--steps");
    if (options.steps && options.steps->text == "auto") options.steps.reset();
    options.until = words.value("--until");
    options.sweeps = words.whole_number("--sweeps").value_or(0);
    options.items = items_of_report(words);
    options.output = output_option(words);
    if (options.scenes.empty() && options.items.contains(ReportItem::work))
        refuse_without_scene(line);
    return options;
}

SymmetriesOptions symmetries_options(const Words& words, const CommandLine& line) {
    SymmetriesOptions options;
    options.system = needed_system(words, line);
    prefer_loops(options.system);
    options.parameters = words.texts("--param");
    options.format = words.choice<CertificateFormat>("--format").value_or(options.format);
    options.output = output_option(words);
    return options;
}

ShowOptions show_options(const Words& words, const CommandLine& line) {
    const Given scene = words.value("SCENE");
    if (!scene)
        throw InputError("no scene is given", line.end(),
                         "for example kepler, which `hvi-gen list scenes` shows");
    return {scene, output_option(words)};
}

/// Returns the text of `hvi-gen COMMAND --help`.
Request help_request(const Words& words) {
    std::vector<std::string> line = {"hvi-gen"};
    if (const auto command = words.choice<Command>("COMMAND"))
        line.emplace_back(entry_of(*command).name);
    line.emplace_back("--help");
    std::vector<const char*> arguments;
    for (const std::string& word : line) arguments.push_back(word.c_str());
    return parse(CommandLine(static_cast<int>(arguments.size()), arguments.data()));
}

ListOptions list_options(const Words& words, const CommandLine& line) {
    ListOptions options{words.choice<Topic>("TOPIC").value_or(Topic::all), {}};
    if (const Given scene = words.value("SCENE")) {
        options.system.emplace().scene = scene;
        options.system->split = words.choice<SplitChoice>("--split");
        if (options.system->split == SplitChoice::none)
            throw InputError(
                "there are no parts to list with --split none", whole(words.value("--split")),
                "--split auto lists those that are found, and T(p) + U(q) beside them");
    }
    const bool takes_scene = options.topic == Topic::splits;
    if (takes_scene && !options.system)
        throw InputError("no scene is given", line.end(),
                         "for example `hvi-gen list splits heavy-top`");
    if (options.system && !takes_scene)
        throw InputError("this topic takes no scene", whole(options.system->scene),
                         "`hvi-gen list splits SCENE` lists parts of its H with known flows");
    return options;
}

CompletionsOptions completions_options(const Words& words, const CommandLine& line) {
    const auto shell = words.choice<Shell>("SHELL");
    if (!shell)
        throw InputError("no shell is given", line.end(),
                         names_of(option_of(words.command(), "SHELL").choices));
    return {*shell, output_option(words)};
}

/// Returns the command that the line names.
const CLI::App& command_of(const CLI::App& app, const CommandLine& line) {
    const std::vector<std::string> rest = app.remaining();
    const auto commands = app.get_subcommands();
    if (!commands.empty() && rest.empty()) return *commands.front();
    if (rest.empty())
        throw InputError("no command is given", line.end(), "`hvi-gen --help` lists the commands");
    if (rest.front().starts_with("-"))
        throw InputError(
            "unknown option `" + rest.front() + "`", line.place({rest.front()}),
            "options of a command stand behind it, as in hvi-gen tableau --method gauss:2");
    std::vector<std::string_view> names;
    for (const CommandEntry& entry : command_table())
        if (entry.state == State::built) names.push_back(entry.name);
    throw InputError("unknown command `" + rest.front() + "`", line.place({rest.front()}),
                     did_you_mean(rest.front(), names, "`hvi-gen --help` lists the commands"));
}

Request request(const CLI::App& parsed, const CommandLine& line) {
    const CommandEntry* const entry = find_command(parsed.get_name());
    HVI_CHECK(entry != nullptr);
    check_command(*entry, line);
    const Words words(entry->command, parsed, line);
    check_rules(words, line);
    switch (entry->command) {
    case Command::tableau: return tableau_options(words, line);
    case Command::check: return check_options(words, line);
    case Command::stepper: return stepper_options(words, line);
    case Command::scheme: return scheme_options(words, line);
    case Command::run: return run_options(words, line);
    case Command::report: return report_options(words, line);
    case Command::symmetries: return symmetries_options(words, line);
    case Command::show: return show_options(words, line);
    case Command::list: return list_options(words, line);
    case Command::cache: return CacheOptions{words.has("--clear")};
    case Command::completions: return completions_options(words, line);
    case Command::manual: return ManualOptions{output_option(words)};
    case Command::help: return help_request(words);
    case Command::module: return module_options(words, line);
    case Command::ensemble: return ensemble_options(words, line);
    case Command::collect: return collect_options(words, line);
    case Command::solve: break;  // to come
    }
    HVI_CHECK(false);
    return Information{};
}

}  // namespace

Request parse(const CommandLine& line) {
    CLI::App app;
    describe(app);
    try {
        app.parse(std::vector<std::string>(line.words().rbegin(), line.words().rend()));
        return request(command_of(app, line), line);
    } catch (const CLI::Success& asked) {  // --help, --version
        if (!app.remaining().empty()) static_cast<void>(command_of(app, line));
        std::ostringstream text;
        app.exit(asked, text, text);
        return Information{text.str()};
    } catch (const CLI::ArgumentMismatch&) {
        throw InputError(line.words().back() + " needs a value", line.last());
    }
}

}  // namespace hvi::gen
