// The targets of the whole program.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/commands.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <system_error>
#include <variant>
#include <vector>

#include <nlohmann/json.hpp>

#include "generator/cli/method.hpp"
#include "generator/cli/run_wishes.hpp"
#include "generator/emit/text/names.hpp"
#include "generator/ensembles/grid.hpp"
#include "generator/ensembles/laws.hpp"
#include "generator/exact/methods/galerkin_rule.hpp"
#include "generator/module/module.hpp"
#include "generator/render/render.hpp"
#include "generator/scene/step_count.hpp"
#include "generator/simulate/simulation.hpp"
#include "generator/support/output_file.hpp"
#include "generator/symmetry/watched.hpp"
#include "tests/generator/fuzz/attempt.hpp"
#include "tests/generator/fuzz/grammars.hpp"
#include "tests/generator/fuzz/header_text.hpp"
#include "tests/generator/fuzz/targets.hpp"

namespace hvi::gen::fuzz {

namespace {

namespace fs = std::filesystem;

/// A directory of this process, gone with it.
class Directory {
public:
    Directory() {
        std::string name = fs::temp_directory_path() / "hvi-fuzz-XXXXXX";
        require(::mkdtemp(name.data()) != nullptr, "no directory for files");
        path_ = name;
        write_file(path_ / "V.hpp", "// for nobody's eyes\n");
    }
    ~Directory() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    Directory(const Directory&) = delete;
    Directory& operator=(const Directory&) = delete;

    [[nodiscard]] const fs::path& path() const { return path_; }

private:
    fs::path path_;
};

fs::path path_of(const char* file) {
    static const Directory directory;
    return directory.path() / file;
}

std::string contents(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// The words of a command line; the file that FILE names is written.
std::vector<std::string> words_of(std::string_view bytes) {
    std::vector<std::string> words;
    while (!bytes.empty() && bytes.front() != '\n') {
        const std::size_t end = std::min(bytes.find('\n'), bytes.size());
        std::string word(bytes.substr(0, end));
        std::replace(word.begin(), word.end(), '\0', ' ');  // which ends an argument
        if (word == "\"\"") word.clear();
        if (word == "FILE") word = path_of("FILE");
        words.push_back(std::move(word));
        bytes.remove_prefix(std::min(end + 1, bytes.size()));
    }
    fs::remove(path_of("FILE"));  // of another input
    if (!bytes.empty()) write_file(path_of("FILE"), bytes.substr(1));
    return words;
}

Request read(const std::vector<std::string>& words) {
    std::vector<const char*> arguments{"hvi-gen"};
    for (const std::string& word : words) arguments.push_back(word.c_str());
    return parse(CommandLine(static_cast<int>(arguments.size()), arguments.data()));
}

/// Carries out a command whose result goes to a file, and returns its contents.
template <class Options>
std::string result(Options options) {
    options.output = path_of("OUTPUT");
    run(options);
    std::string text = contents(*options.output);
    require(text.ends_with('\n'), "a result that does not end in a newline");
    return text;
}

void check_json(const std::string& text) {
    require(nlohmann::json::accept(text), "JSON that is none");
}

/// Checks that all formats show a method, if one does.
void check_formats(const auto& method, int digits) {
    require(!render_text(method, digits).empty(), "no text");
    try {
        check_json(render_json(method, digits));
        for (const std::string& text :
             {render_latex(method, digits), render_markdown(method, digits),
              render_csv(method, digits)})
            require(!text.empty(), "no text");
    } catch (const MathError& error) {
        throw std::logic_error(std::string("text can say what others cannot: ") + error.what());
    }
}

void carry_out(const TableauOptions& options) {
    std::visit([&](const auto& method) { check_formats(method, options.digits); },
               derive_any(method_of(options.method)));
}

void carry_out(CheckOptions options) {
    if (options.plot) options.plot = given("--plot", path_of("PLOT"));
    const std::string text = result(options);
    if (options.format == CheckOptions::Format::json) check_json(text);
}

void carry_out(const SchemeOptions& options) {
    const std::string text = result(options);
    if (options.format == SchemeOptions::Format::json) check_json(text);
}

void carry_out(const SymmetriesOptions& options) {
    const std::string text = result(options);
    if (options.format == SymmetriesOptions::Format::json) check_json(text);
}

void carry_out(StepperOptions options) {
    if (options.accuracy) return;
    options.explain = false;
    check_header(result(options));
}

/// Up to where the compiler starts.
void carry_out(const RunOptions& options) {
    if (options.accuracy) return;
    MethodAndScene both = read_scene(options.method, options.system);
    const SceneTimes times = times_of(both.scene);
    static_cast<void>(steps_until(times, wish(times, options.step, times.step, "step"),
                                  wish(times, options.until, times.until, "until")));
    const StepperWishes wishes =
        simulation_wishes(options.wishes.solver, options.wishes.composition);
    const Watched watched = watch(both.scene, options.system.sums);
    const SceneStepper stepper = scene_stepper(both.method, both.scene, wishes);
    static_cast<void>(watched.statements(keeping_facts(stepper.method.base)));
    check_parameter_of_method(stepper);
    check_header(stepper.header);
}

/// Up to where files are written.
void carry_out(const ModuleOptions& options) {
    if (options.name) check_module_name(options.name->text, whole(options.name));
    const MethodAndScene both = read_scene(options.method, options.system);
    const std::string name = options.name ? options.name->text : module_name(both.scene.name);
    const SceneStepper stepper =
        scene_stepper(both.method, both.scene, module_wishes(options.wishes, name));
    check_parameter_of_method(stepper);
    check_header(stepper.header);
    const CModule module = c_module(stepper, name, "hvi-gen module");
    const std::string step = "int " + name + "_step(";
    require(module.header.find(step) != std::string::npos, "a module without its step");
    require(module.source.find(step) != std::string::npos, "a module without its step");
}

/// Up to where the compiler starts.
void carry_out(const EnsembleOptions& options) {
    const MethodAndScene both = read_scene(options.method, options.system);
    const SceneTimes times = times_of(both.scene);
    for (const Given& text : options.vary) require(grid(text, times).count > 0, "an empty grid");
    for (const Given& text : options.random) static_cast<void>(law(text, times));
}

void carry_out(const CollectOptions&) {}  // what it reads is outside
void carry_out(const ReportOptions&) {}
void carry_out(const CacheOptions&) {}  // what it does is outside
void carry_out(const ListOptions&) {}
void carry_out(const ShowOptions& options) { require(!scene_text(options.scene).empty(), "no scene"); }
void carry_out(const CompletionsOptions& options) { static_cast<void>(result(options)); }
void carry_out(const ManualOptions& options) { static_cast<void>(result(options)); }
void carry_out(const Information& information) { require(!information.text.empty(), "no help"); }

std::string derived(const Grammar& grammar, std::string_view bytes) {
    std::string text = grammar.derive(bytes);
    if (std::getenv("HVI_FUZZ_SHOW") != nullptr) std::fputs(text.c_str(), stderr);
    return text;
}

}  // namespace

void command_line(std::string_view bytes) {
    const std::vector<std::string> words = words_of(bytes);
    attempt([&] { static_cast<void>(read(words)); });
}

void command(std::string_view bytes) {
    const std::vector<std::string> words = words_of(bytes);
    attempt([&] { std::visit([](const auto& options) { carry_out(options); }, read(words)); });
}

void derived_command_line(std::string_view bytes) { command_line(derived(command_lines(), bytes)); }
void derived_method(std::string_view bytes) { command(derived(methods(), bytes)); }
void derived_scene(std::string_view bytes) { command(derived(scenes(), bytes)); }
void derived_search(std::string_view bytes) { command(derived(searches(), bytes)); }
void derived_tableau_file(std::string_view bytes) { command(derived(tableau_files(), bytes)); }

}  // namespace hvi::gen::fuzz
