// CLI11 splits the command line; what its words mean, and what is wrong with them, is said here.
// SPDX-License-Identifier: GPL-2.0-or-later
//
// NOTE: CLI11 gets neither limits nor types nor exclusions to check, because its messages know no
// place. It only refuses a last option without its value.
#include "generator/cli/options.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <sstream>
#include <string_view>
#include <utility>

#include <CLI/CLI.hpp>

#include "generator/exact/trees.hpp"
#include "generator/read/nearest.hpp"
#include "generator/support/version.hpp"

namespace hvi::gen {

namespace {

constexpr std::string_view method_help = R"help(METHOD is one of
  --method gauss:3                          `hvi-gen list methods` prints them all
  --basis "1, cos(pi*tau)" --nodes "0, 1"   functions of tau in [0,1], as many as nodes
  --method-file FILE.toml                   with name, basis, nodes, [parameters])help";

/// Options that stand in place of a scene.
constexpr std::array hamiltonian_options = {"--hamiltonian", "--coordinates", "--momenta"};

const std::vector<std::string_view> topics = {"", "bases", "nodes", "methods", "scenes"};

[[noreturn]] void to_come(const std::string& what, Place place) {
    throw InputError(what + " is announced, but not built yet", std::move(place));
}

/// A place that is the whole of an option's value.
Place value_place(const std::string& option, const std::string& value) {
    return {std::make_shared<const Source>(Source{option, value}), {0, value.size()}};
}

void add_value(CLI::App& command, const std::string& names, const std::string& type,
               const std::string& help) {
    // NOTE: exactly one value for each occurrence, so that no word behind it is swallowed.
    command
        .add_option(
            names, [](const CLI::results_t&) { return true; }, help)
        ->expected(1)
        ->allow_extra_args(false)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->type_name(type);
}

void add_flag(CLI::App& command, const std::string& name, const std::string& help) {
    command.add_flag(name, help);
}

void add_method(CLI::App& command) {
    add_value(command, "--method", "NAME", "A named method or family");
    add_value(command, "--basis", "FUNCTIONS", "Basis functions of tau");
    add_value(command, "--nodes", "NODES", "Nodes in [0,1]");
    add_value(command, "--weights", "WEIGHTS", "Weights of the general form (to come)");
    add_value(command, "--method-file", "FILE", "A method in TOML");
    add_value(command, "--param", "NAME=VALUE", "The value of a parameter; repeatable");
    command.footer(std::string(method_help));
}

void add_system(CLI::App& command) {
    add_value(command, "SCENE", "SCENE", "A system by name (`hvi-gen list scenes`), or in TOML");
    add_value(command, "--hamiltonian", "H", "Or H(q, p, t), as in \"p^2/2 + w^2*q^2/2\"");
    add_value(command, "--coordinates", "NAMES", "Its coordinates (q, or q1, q2, ... in H)");
    add_value(command, "--momenta", "NAMES", "Their momenta (p, or p1, p2, ...)");
}

/// The grammar of the command line.
void describe(CLI::App& app) {
    app.name("hvi-gen");
    app.description("Derives symplectic integrators exactly and writes them as C++ headers.");
    app.set_version_flag("--version", "hvi-gen " + std::string(version));
    app.require_subcommand(0, 1);
    app.allow_extras();

    CLI::App& tableau = *app.add_subcommand("tableau", "Print the exact tableau of a method");
    add_method(tableau);
    add_value(tableau, "--format", "FORMAT", "text, json, latex, markdown or csv");
    add_value(tableau, "--digits", "N", "Significant digits of decimal values (50)");
    add_value(tableau, "-o,--output", "FILE", "Write to this file");

    CLI::App& check =
        *app.add_subcommand("check", "Order, symplecticity, symmetry, stability, with proof");
    add_method(check);
    add_value(check, "--tableau", "FILE", "A tableau in JSON, from wherever, in place of METHOD");
    add_value(check, "--max-order", "N", "Look at conditions up to this order (8)");
    add_value(check, "--format", "FORMAT", "text or json");
    add_value(check, "--plot", "FILE", "Draw trace/2 on the oscillator as SVG");
    add_value(check, "-o,--output", "FILE", "Write to this file");

    CLI::App& stepper = *app.add_subcommand("stepper", "Write a method as a C++ header");
    add_method(stepper);
    add_system(stepper);
    add_flag(stepper, "--separable", "For a class of your own with H = T(p) + U(q)");
    add_value(stepper, "--solver", "SOLVER", "auto, fixed-point, newton or newton-taylor");
    add_flag(stepper, "--energy", "The class has a member energy(x)");
    add_flag(stepper, "--invariants", "And one for each invariant of the scene");
    add_flag(stepper, "--evaluations", "And one that counts those of dH/dq");
    add_flag(stepper, "--dense", "And one for positions within the last step");
    add_value(stepper, "--name", "NAME", "Name of the class");
    add_flag(stepper, "--explain", "Say what is solved and what is left out");
    add_value(stepper, "-o,--output", "FILE", "Write to this file");

    CLI::App& scheme =
        *app.add_subcommand("scheme", "Print the equations of a step for a Hamiltonian");
    add_method(scheme);
    add_system(scheme);
    add_flag(scheme, "--generating", "Also the generating function, of a quadratic H");
    add_value(scheme, "--format", "FORMAT", "text, json or latex");
    add_value(scheme, "-o,--output", "FILE", "Write to this file");

    CLI::App& run = *app.add_subcommand("run", "Integrate a scene: table, picture, summary");
    add_method(run);
    add_value(run, "SCENE", "SCENE", "A scene by name (`hvi-gen list scenes`), or in TOML");
    add_value(run, "--step", "H", "Size of a step, in place of the scene's");
    add_value(run, "--until", "T", "Time at the end, in place of the scene's");
    add_value(run, "--solver", "SOLVER", "auto, fixed-point, newton or newton-taylor");
    add_value(run, "--only", "LIST", "Of table, picture, summary; all when not given");
    add_value(run, "-o,--output", "DIR", "Write to this directory");

    CLI::App& report =
        *app.add_subcommand("report", "Error against run time, of methods on scenes");
    report
        .add_option(
            "SCENE", [](const CLI::results_t&) { return true; }, "Scenes by name, or in TOML")
        ->expected(1)
        ->allow_extra_args()  // of one for each of them: as many as there are
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->type_name("SCENE...");
    add_value(report, "--methods", "LIST", "Names of methods between commas");
    add_value(report, "--steps", "LIST", "Sizes of steps between commas, or auto");
    add_value(report, "--until", "T", "Time at the end, in place of the scene's");
    add_value(report, "--only", "LIST", "Of html, json, csv, svg; all when not given");
    add_flag(report, "--peers", "Other libraries too (to come)");
    add_flag(report, "--edges", "Stiff and extreme cases (to come)");
    add_value(report, "-o,--output", "DIR", "Write to this directory (report)");

    CLI::App& list = *app.add_subcommand("list", "Print what can be named");
    add_value(list, "TOPIC", "TOPIC", "bases, nodes, methods or scenes; all when not given");

    for (CLI::App* command : app.get_subcommands(nullptr)) command->allow_extras();
}

using OptionGroups = std::vector<std::vector<std::string>>;

/// A command with the words that CLI11 gave to its options.
class Words {
public:
    Words(const CLI::App& command, const CommandLine& line) : command_(command), line_(line) {}

    /// CLI11 takes the next word for a value, even when it is another option.
    void check_values() const {
        for (const CLI::Option* option : command_.get_options()) {
            const auto& values = option->results();
            for (std::size_t i = 0; i < values.size(); ++i) {
                const std::string word = values[i].substr(0, values[i].find('='));
                if (word.starts_with("-") && command_.get_option_no_throw(word))
                    throw InputError(option->get_name() + " needs a value",
                                     place(option->get_name(), i));
            }
        }
    }

    /// The place of the n-th occurrence of an option, by whichever of its names.
    [[nodiscard]] Place place(const std::string& option, std::size_t n = 0) const {
        std::vector<std::string> names;
        for (const std::string& name : command_.get_option(option)->get_snames())
            names.push_back("-" + name);
        for (const std::string& name : command_.get_option(option)->get_lnames())
            names.push_back("--" + name);
        return line_.place(names, n);
    }

    /// The values of an option, one for each occurrence.
    [[nodiscard]] const std::vector<std::string>& values(const std::string& option) const {
        return command_.get_option(option)->results();
    }

    /// The value of an option that can be given once.
    [[nodiscard]] std::optional<std::string> value(const std::string& option) const {
        const auto& given = values(option);
        if (given.empty()) return {};
        if (given.size() > 1) throw InputError(option + " is given twice", place(option, 1));
        return given.front();
    }

    [[nodiscard]] bool flag(const std::string& option) const {
        for (const std::string& value : command_.get_option(option)->results())
            if (value != "true") throw InputError(option + " takes no value", place(option));
        return command_.count(option) > 0;
    }

    /// Checks that the options that are given are all of one group.
    void one_form_of(const OptionGroups& groups) const {
        const std::string* first = nullptr;
        for (const auto& group : groups) {
            const std::string* here = nullptr;
            for (const std::string& option : group)
                if (!here && !values(option).empty()) here = &option;
            if (first && here)
                throw InputError(*first + " and " + *here + " each give a method", place(*here),
                                 "leave one of them out");
            if (here) first = here;
        }
    }

    [[nodiscard]] std::optional<int> number(const std::string& option, int least, int most) const {
        const auto given = value(option);
        if (!given) return {};
        int number = 0;
        const auto [end, error] =
            std::from_chars(given->data(), given->data() + given->size(), number);
        const bool whole = error == std::errc{} && end == given->data() + given->size();
        if (!whole || number < least || number > most)
            throw InputError(option + " takes a whole number from " + std::to_string(least) +
                                 " to " + std::to_string(most),
                             value_place(option, *given));
        return number;
    }

    /// The value of an option with a few possible ones; the first when it is not given.
    [[nodiscard]] std::size_t choice(const std::string& option,
                                     const std::vector<std::string_view>& choices) const {
        const auto given = value(option);
        if (!given) return 0;
        for (std::size_t i = 0; i < choices.size(); ++i) {
            if (choices[i] == *given) return i;
        }
        std::string all;
        for (const std::string_view each : choices)
            all.append(all.empty() ? "" : ", ").append(each);
        throw InputError("no such value of " + option + ": `" + *given + "`",
                         value_place(option, *given),
                         did_you_mean(*given, choices, "one of " + all));
    }

private:
    const CLI::App& command_;
    const CommandLine& line_;
};

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
    method.parameters = words.values("--param");
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

std::string trimmed(const std::string& text) {
    const std::size_t begin = text.find_first_not_of(' ');
    return begin == std::string::npos ? ""
                                      : text.substr(begin, text.find_last_not_of(' ') + 1 - begin);
}

std::optional<std::filesystem::path> file_option(const Words& words, const std::string& option) {
    const auto file = words.value(option);
    if (file && file->empty()) {
        throw InputError(option + " needs the name of a file", words.place(option));
    }
    return file;
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
        options.method.parameters = words.values("--param");
    } else {
        options.method = method_options(words, line);
    }
    options.max_order = words.number("--max-order", 1, most_vertices).value_or(options.max_order);
    options.format = static_cast<CheckOptions::Format>(words.choice("--format", {"text", "json"}));
    options.plot = file_option(words, "--plot");
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
                                 line.place({*system.scene}), "leave one of them out");
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
    if (!options.system && words.value("--solver"))
        throw InputError("--solver needs a scene or --hamiltonian", words.place("--solver"),
                         "the solver of a header for any H is an argument of its class");
}

MethodOptions method_beside_scene(const Words& words, const CommandLine& line) {
    if (names_method(words)) return method_options(words, line);
    MethodOptions of_scene;
    of_scene.parameters = words.values("--param");
    return of_scene;
}

Solver solver_option(const Words& words) {
    constexpr std::array solvers{Solver::automatic, Solver::fixed_point, Solver::newton,
                                 Solver::newton_taylor};
    return solvers.at(words.choice("--solver", {"auto", "fixed-point", "newton", "newton-taylor"}));
}

StepperOptions stepper_options(const Words& words, const CommandLine& line) {
    StepperOptions options;
    options.system = system_options(words, line);
    options.method = options.system && options.system->scene ? method_beside_scene(words, line)
                                                             : method_options(words, line);
    options.separable = words.flag("--separable");
    options.wishes.solver = solver_option(words);
    options.wishes.energy = words.flag("--energy");
    options.wishes.invariants = words.flag("--invariants");
    options.wishes.evaluations = words.flag("--evaluations");
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

/// The items of a list between commas, which are among `choices`; all of these when not given.
std::vector<bool> chosen(const Words& words, const std::string& option,
                         const std::vector<std::string_view>& choices) {
    const auto given = words.value(option);
    std::vector<bool> is_chosen(choices.size(), !given);
    std::string all;
    for (const std::string_view each : choices) all.append(all.empty() ? "" : ", ").append(each);
    for (std::size_t begin = 0; given && begin <= given->size();) {
        const std::size_t end = std::min(given->find(',', begin), given->size());
        const std::string item = trimmed(given->substr(begin, end - begin));
        const auto found = std::find(choices.begin(), choices.end(), item);
        if (found == choices.end())
            throw InputError("no such item of " + option + ": `" + item + "`",
                             Place{value_place(option, *given).source, {begin, end}},
                             did_you_mean(item, choices, "some of " + all));
        is_chosen[static_cast<std::size_t>(found - choices.begin())] = true;
        begin = end + 1;
    }
    return is_chosen;
}

RunOptions run_options(const Words& words, const CommandLine& line) {
    RunOptions options;
    options.method = method_beside_scene(words, line);
    options.system.scene = words.value("SCENE");
    if (!options.system.scene)
        throw InputError("no scene is given", line.end(),
                         "for example kepler, which `hvi-gen list scenes` shows");
    options.solver = solver_option(words);
    options.step = words.value("--step");
    options.until = words.value("--until");
    const std::vector<bool> only = chosen(words, "--only", {"table", "picture", "summary"});
    options.table = only[0];
    options.picture = only[1];
    options.summary = only[2];
    options.output = file_option(words, "--output");
    return options;
}

ReportOptions report_options(const Words& words, const CommandLine& line) {
    ReportOptions options;
    options.scenes = words.values("SCENE");
    if (options.scenes.empty())
        throw InputError("no scene is given", line.end(),
                         "for example kepler, which `hvi-gen list scenes` shows");
    for (const char* flag : {"--peers", "--edges"})
        if (words.flag(flag)) to_come(flag, words.place(flag));
    options.methods = words.value("--methods");
    options.steps = words.value("--steps");
    if (options.steps == "auto") options.steps.reset();
    options.until = words.value("--until");
    const std::vector<bool> only = chosen(words, "--only", {"html", "json", "csv", "svg"});
    options.html = only[0];
    options.json = only[1];
    options.csv = only[2];
    options.svg = only[3];
    options.output = file_option(words, "--output");
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
