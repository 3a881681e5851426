// `hvi-gen module`: a stepper of a scene for C, and for languages that call C.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/module/module.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

#include "generator/cli/commands.hpp"
#include "generator/cli/method.hpp"
#include "generator/cli/run_wishes.hpp"
#include "generator/emit/text/names.hpp"
#include "generator/module/python_package.hpp"
#include "generator/options/option_table.hpp"
#include "generator/program/builds.hpp"
#include "generator/read/names.hpp"
#include "generator/scene/step_count.hpp"
#include "generator/support/error.hpp"
#include "generator/support/output_file.hpp"
#include "generator/support/process.hpp"

namespace hvi::gen {

namespace {

/// Returns the command that writes these files.
std::string command(const SceneStepper& stepper, const std::string& scene,
                    const ModuleOptions& options) {
    return "hvi-gen module " + stepper.method.provenance().origin + " " + scene +
           options_for(options.wishes, Command::module) +
           (options.name ? " --name " + options.name->text : "") +
           (options.language == Language::python ? " --language python" : "");
}

/// Returns the module's text for a compiler. NOTE: it stands with the user's headers in a directory
/// of its own, under a name that none of them can have.
ProgramText program_text(const CModule& module, const std::string& name,
                         const std::vector<OwnHeader>& own) {
    ProgramText text{
        .main = "#include \"scene/~module.cpp\"\n",
        .headers = {{"scene/~module.cpp", module.source}, {"scene/" + name + ".h", module.header}},
        .artifact = Artifact::library};
    for (const OwnHeader& header : own) text.headers.emplace("scene/" + header.path, header.text);
    return text;
}

std::string contents(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    if (!(text << file.rdbuf()))
        throw EnvironmentError("cannot read the compiled library " + path.string());
    return std::move(text).str();
}

/// Parameters that are computed from others.
std::vector<ComputedParameter> computed_parameters(const Scene& scene) {
    std::set<std::string> names;
    for (const IndexedValue& each : scene.parameters) names.insert(each.name);
    std::vector<ComputedParameter> result;
    for (const IndexedValue& each : scene.parameters) {
        const auto* value = std::get_if<IndexedExpression>(&each.value);
        if (value == nullptr) continue;
        std::set<std::string> symbols;
        insert_parameters(value->written, symbols);
        const bool is_computed = std::any_of(
            symbols.begin(), symbols.end(), [&](const auto& name) { return names.contains(name); });
        if (is_computed) result.push_back({each.name, to_text(value->written)});
    }
    return result;
}

PackageScene package_scene(const Scene& scene) {
    const SceneTimes times = times_of(scene);
    PackageScene result;
    result.computed = computed_parameters(scene);
    if (times.step) result.step = nearest_value(times, *times.step);
    if (times.until) result.until = nearest_value(times, *times.until);
    return result;
}

/// Returns the files of the package; compiles the library among them.
std::vector<PackageFile> package(const SceneStepper& stepper, const CModule& module,
                                 const std::string& name, const std::string& command,
                                 const PackageScene& scene) {
    Builds builds(find_compiler());
    const std::filesystem::path library =
        built(builds.order(program_text(module, name, stepper.own_headers)));
    std::vector<PackageFile> files = python_package(stepper, name, command, scene);
    files.push_back({package_library(name), contents(library)});
    return files;
}

std::vector<PackageFile> files_of(const SceneStepper& stepper, const Scene& scene,
                                  const std::string& name, const ModuleOptions& options) {
    const std::string line = command(stepper, scene.origin, options);
    const CModule module = c_module(stepper, name, line);
    if (options.language == Language::python)
        return package(stepper, module, name, line, package_scene(scene));
    return {{name + ".h", module.header}, {name + ".cpp", module.source}};
}

}  // namespace

void run(const ModuleOptions& options) {
    if (options.name) check_module_name(options.name->text, whole(options.name));
    const MethodAndScene both = read_scene(options.method, options.system);
    const std::string name = options.name ? options.name->text : module_name(both.scene.name);
    const SceneStepper stepper =
        scene_stepper(both.method, both.scene, module_wishes(options.wishes, name));
    check_parameter_of_method(stepper);
    const InterruptionsHeld held;
    const std::vector<PackageFile> files = files_of(stepper, both.scene, name, options);
    const bool is_package = options.language == Language::python;
    const std::filesystem::path folder = is_package ? options.output / name : options.output;
    make_directory(folder);
    std::string written;
    for (const PackageFile& file : files) {
        write_file(folder / file.name, file.text);
        written += (folder / file.name).string() + "\n";
    }
    write_standard_output(written);
}

}  // namespace hvi::gen
