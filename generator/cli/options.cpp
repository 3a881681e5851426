// CLI11 splits the command line; what its words mean, and what is wrong with them, is said here.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/options.hpp"

#include <algorithm>
#include <array>
#include <sstream>
#include <string_view>
#include <utility>

#include "generator/cli/grammar.hpp"
#include "generator/cli/only.hpp"
#include "generator/cli/words.hpp"
#include "generator/exact/methods/trees.hpp"
#include "generator/read/nearest.hpp"

namespace hvi::gen {

namespace {

/// Options that stand in place of a scene.
constexpr std::array hamiltonian_options = {"--hamiltonian", "--coordinates", "--momenta"};

const std::vector<std::string_view> topics = {"",        "bases",  "nodes",
                                              "methods", "scenes", "functions"};

const OptionGroups forms_of_method{
    {"--method"}, {"--basis", "--nodes", "--weights"}, {"--method-file"}};

MethodOptions method_options(const Words& words, const CommandLine& line) {
    words.one_form_of(forms_of_method);

    MethodOptions method;
    method.name = words.value("--method");
    method.basis = words.value("--basis");
    method.nodes = words.value("--nodes");
    method.weights = words.value("--weights");
    method.file = words.value("--method-file");
    method.parameters = words.texts("--param");
    if (!method.name && !method.basis && !method.nodes && !method.weights && !method.file)
        throw InputError("no method is given", line.end(), "for example --method gauss:2");
    if (method.weights && !method.basis)
        throw InputError("--weights needs --basis and --nodes", words.place("--weights"));
    if (method.nodes && !method.basis)
        throw InputError("--nodes needs --basis", words.place("--nodes"));
    if (method.basis && !method.nodes)
        throw InputError("--basis needs --nodes", words.place("--basis"));
    return method;
}

Given given_file(const Words& words, const std::string& option) {
    Given file = words.value(option);
    if (file && file->text.empty()) {
        throw InputError(option + " needs the name of a file", words.place(option));
    }
    return file;
}

std::optional<std::filesystem::path> file_option(const Words& words, const std::string& option) {
    const Given file = given_file(words, option);
    return file ? std::optional<std::filesystem::path>(file->text) : std::nullopt;
}

TableauOptions tableau_options(const Words& words, const CommandLine& line) {
    TableauOptions options;
    options.method = method_options(words, line);
    options.format = static_cast<TableauOptions::Format>(
        words.choice("--format", {"text", "json", "latex", "markdown", "csv"}));
    options.digits = words.number("--digits", 1, 10000).value_or(options.digits);
    options.output = file_option(words, "--output");
    return options;
}

CheckOptions check_options(const Words& words, const CommandLine& line) {
    CheckOptions options;
    OptionGroups forms = forms_of_method;
    forms.push_back({"--tableau"});
    words.one_form_of(forms);
    options.tableau = file_option(words, "--tableau");
    if (options.tableau) {
        options.method.parameters = words.texts("--param");
    } else {
        options.method = method_options(words, line);
    }
    options.max_order = words.number("--max-order", 1, most_vertices).value_or(options.max_order);
    options.format = static_cast<CheckOptions::Format>(words.choice("--format", {"text", "json"}));
    options.plot = given_file(words, "--plot");
    options.output = file_option(words, "--output");
    return options;
}

/// Empty where no system is named.
std::optional<SystemOptions> system_options(const Words& words, const CommandLine& line) {
    SystemOptions system;
    system.scene = words.value("SCENE");
    if (system.scene) {
        for (const char* option : hamiltonian_options)
            if (!words.values(option).empty())
                throw InputError("a scene and " + std::string(option) + " exclude each other",
                                 line.place({system.scene->text}), "leave one of them out");
    }
    system.hamiltonian = words.value("--hamiltonian");
    system.coordinates = words.value("--coordinates");
    system.momenta = words.value("--momenta");
    if (system.coordinates && !system.momenta)
        throw InputError("--coordinates needs --momenta", words.place("--coordinates"));
    if (system.momenta && !system.coordinates)
        throw InputError("--momenta needs --coordinates", words.place("--momenta"));
    if (system.scene || system.hamiltonian) return system;
    if (system.coordinates)
        throw InputError("--coordinates needs --hamiltonian", words.place("--coordinates"));
    return {};
}

/// Whether a method is given; a scene may name one instead.
bool names_method(const Words& words) {
    return std::any_of(forms_of_method.begin(), forms_of_method.end(), [&](const auto& group) {
        return std::any_of(group.begin(), group.end(), [&](const std::string& option) {
            return !words.values(option).empty();
        });
    });
}

/// What only a system has.
void check_system_flags(const Words& words, const StepperOptions& options) {
    if (options.system && options.separable)
        throw InputError("--separable is for a class of your own", words.place("--separable"),
                         "whether the H of a scene is T(p) + U(q) is found out");
    for (const char* flag : {"--energy", "--invariants", "--evaluations", "--dense"})
        if (!options.system && words.flag(flag))
            throw InputError(std::string(flag) + " needs a scene or --hamiltonian",
                             words.place(flag));
    if (!options.system && options.wishes.float128)
        throw InputError("--float128 needs a scene or --hamiltonian", words.place("--float128"),
                         "a header for any H computes in what the vectors of its class hold");
    if (!options.system && words.value("--lanes"))
        throw InputError("--lanes needs a scene or --hamiltonian", words.place("--lanes"),
                         "the class of a user computes one gradient at a time");
    if (!options.system && words.value("--solver"))
        throw InputError("--solver needs a scene or --hamiltonian", words.place("--solver"),
                         "the solver of a header for any H is an argument of its class");
}

MethodOptions method_beside_scene(const Words& words, const CommandLine& line) {
    if (names_method(words)) return method_options(words, line);
    MethodOptions of_scene;
    of_scene.parameters = words.texts("--param");
    return of_scene;
}

Solver solver_option(const Words& words) {
    constexpr std::array solvers{Solver::automatic, Solver::fixed_point, Solver::newton,
                                 Solver::newton_taylor};
    return solvers.at(words.choice("--solver", {"auto", "fixed-point", "newton", "newton-taylor"}));
}

std::optional<Place> place_of_value(const Words& words, const std::string& option) {
    const Given text = words.value(option);
    return text ? std::optional(whole(text)) : std::nullopt;
}

Wish<Lanes> lanes_option(const Words& words) {
    constexpr std::array lanes{Lanes::automatic, Lanes::stages, Lanes::none};
    return {lanes.at(words.choice("--lanes", {"auto", "stages", "none"})),
            place_of_value(words, "--lanes")};
}

/// What a stepper may be, and a run, of one trajectory, not.
Wish<Lanes> lanes_of_stepper(const Words& words) {
    constexpr std::array lanes{Lanes::automatic, Lanes::stages, Lanes::ensemble, Lanes::none};
    return {lanes.at(words.choice("--lanes", {"auto", "stages", "ensemble", "none"})),
            place_of_value(words, "--lanes")};
}

std::optional<Composition> composition_option(const Words& words) {
    const Given name = words.value("--compose");
    return name ? std::optional(named_composition(name)) : std::nullopt;
}

/// What is left to it is not to be given.
std::optional<double> accuracy_option(const Words& words,
                                      const std::vector<std::string>& left_to_it) {
    const std::optional<double> accuracy = words.fraction("--accuracy");
    if (!accuracy) return {};
    OptionGroups groups = forms_of_method;
    groups.push_back(left_to_it);
    for (const auto& group : groups)
        for (const std::string& option : group)
            if (!words.values(option).empty())
                throw InputError("--accuracy chooses what " + option + " gives",
                                 words.place(option), "leave one of them out");
    if (!words.value("SCENE"))
        throw InputError("--accuracy needs a scene", words.place("--accuracy"),
                         "one that has a start and an end, such as kepler");
    return accuracy;
}

StepperOptions stepper_options(const Words& words, const CommandLine& line) {
    StepperOptions options;
    options.system = system_options(words, line);
    options.accuracy = accuracy_option(words, {"--solver", "--lanes", "--compose"});
    options.until = words.value("--until");
    if (options.until && !options.accuracy)
        throw InputError("--until goes with --accuracy", words.place("--until"),
                         "a header takes steps for as long as its user likes");
    options.method = options.system && options.system->scene ? method_beside_scene(words, line)
                                                             : method_options(words, line);
    options.separable = words.flag("--separable");
    options.wishes.solver = solver_option(words);
    options.wishes.lanes = lanes_of_stepper(words);
    options.wishes.composition = composition_option(words);
    options.wishes.energy = words.flag("--energy");
    options.wishes.invariants = words.flag("--invariants");
    options.wishes.evaluations = words.flag("--evaluations");
    options.wishes.float128 = words.flag("--float128");
    options.wishes.dense = words.flag("--dense");
    check_system_flags(words, options);
    options.wishes.class_name = words.value("--name");
    options.explain = words.flag("--explain");
    options.output = file_option(words, "--output");
    return options;
}

SchemeOptions scheme_options(const Words& words, const CommandLine& line) {
    SchemeOptions options;
    const auto system = system_options(words, line);
    options.method = method_options(words, line);
    if (!system)
        throw InputError("no Hamiltonian is given", line.end(),
                         "for example kepler, which `hvi-gen list scenes` shows, or --hamiltonian "
                         "\"p^2/2 + w^2*q^2/2\"");
    options.system = *system;
    options.generating = words.flag("--generating");
    options.format =
        static_cast<SchemeOptions::Format>(words.choice("--format", {"text", "json", "latex"}));
    options.output = file_option(words, "--output");
    return options;
}

RunOptions run_options(const Words& words, const CommandLine& line) {
    RunOptions options;
    options.method = method_beside_scene(words, line);
    options.system.scene = words.value("SCENE");
    if (!options.system.scene)
        throw InputError("no scene is given", line.end(),
                         "for example kepler, which `hvi-gen list scenes` shows");
    options.accuracy = accuracy_option(words, {"--solver", "--lanes", "--compose", "--step"});
    options.solver = solver_option(words);
    options.lanes = lanes_option(words);
    options.composition = composition_option(words);
    options.step = words.value("--step");
    options.until = words.value("--until");
    const Only only(words, {"table", "picture", "summary"});
    options.table = only.wants("table");
    options.picture = only.wants("picture");
    options.summary = only.wants("summary");
    options.output = file_option(words, "--output");
    return options;
}

ReportOptions report_options(const Words& words, const CommandLine& line) {
    ReportOptions options;
    options.scenes = words.texts("SCENE");
    const bool has_scenes = !options.scenes.empty(), edges = words.flag("--edges");
    options.peers = words.flag("--peers");
    options.methods = words.value("--methods");
    options.steps = words.value("--steps");
    if (options.steps && options.steps->text == "auto") options.steps.reset();
    options.until = words.value("--until");
    const Only only(words, {"html", "json", "csv", "svg"},
                    {"work", "rejections", "stiff", "extreme", "long", "symplecticity"});
    options.html = only.wants("html");
    options.json = only.wants("json");
    options.csv = only.wants("csv");
    options.svg = only.wants("svg");
    options.parts.work = only.wants_part("work", has_scenes);
    options.parts.rejections = only.wants_part("rejections", true);
    options.parts.stiff = only.wants_part("stiff", edges);
    options.parts.extreme = only.wants_part("extreme", edges);
    options.parts.long_runs = only.wants_part("long", edges);
    options.parts.symplecticity = only.wants_part("symplecticity", true);
    options.output = file_option(words, "--output");
    if (!has_scenes && (options.parts.work || !(edges || only.names_parts())))
        throw InputError("no scene is given", line.end(),
                         "for example kepler, which `hvi-gen list scenes` shows");
    return options;
}

ListOptions list_options(const Words& words) {
    return {std::string(topics[words.choice("TOPIC", topics)])};
}

/// A word that CLI11 could give to nothing.
[[noreturn]] void refuse(const std::string& word, const CLI::App& command,
                         const CommandLine& line) {
    if (word.starts_with("-")) {
        std::vector<std::string> names;
        for (const CLI::Option* option : command.get_options())
            if (!option->get_positional()) names.push_back(option->get_name());
        throw InputError(
            "unknown option `" + word + "`", line.place({word}),
            did_you_mean(word, {names.begin(), names.end()},
                         "`hvi-gen " + command.get_name() + " --help` lists the options"));
    }
    throw InputError("unexpected word `" + word + "`", line.place({word}),
                     "a method is given by --method, as in --method gauss:2");
}

/// The command that the line names.
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
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands(nullptr))
        names.push_back(command->get_name());
    throw InputError("unknown command `" + rest.front() + "`", line.place({rest.front()}),
                     did_you_mean(rest.front(), {names.begin(), names.end()},
                                  "`hvi-gen --help` lists the commands"));
}

Request request(const CLI::App& command, const CommandLine& line) {
    const std::string& name = command.get_name();
    const Words words(command, line);
    words.check_values();
    if (const auto rest = command.remaining(); !rest.empty()) refuse(rest.front(), command, line);

    if (name == "tableau") return tableau_options(words, line);
    if (name == "check") return check_options(words, line);
    if (name == "stepper") return stepper_options(words, line);
    if (name == "scheme") return scheme_options(words, line);
    if (name == "run") return run_options(words, line);
    if (name == "report") return report_options(words, line);
    HVI_CHECK(name == "list");
    return list_options(words);
}

}  // namespace

Request parse(const CommandLine& line) {
    CLI::App app;
    describe(app);
    try {
        app.parse(std::vector<std::string>(line.words().rbegin(), line.words().rend()));
        return request(command_of(app, line), line);
    } catch (const CLI::Success& asked) {  // --help, --version
        std::ostringstream text;
        app.exit(asked, text, text);
        return Information{text.str()};
    } catch (const CLI::ArgumentMismatch&) {
        throw InputError(line.words().back() + " needs a value", line.last());
    }
}

}  // namespace hvi::gen
