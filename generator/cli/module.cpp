// `hvi-gen module`: a stepper of a scene for C, and for what calls C.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/module/module.hpp"

#include <filesystem>

#include "generator/cli/commands.hpp"
#include "generator/cli/method.hpp"
#include "generator/cli/run_wishes.hpp"
#include "generator/emit/text/names.hpp"
#include "generator/options/option_table.hpp"
#include "generator/support/output_file.hpp"
#include "generator/support/process.hpp"

namespace hvi::gen {

namespace {

/// The command that writes the same files.
std::string command(const SceneStepper& stepper, const std::string& scene,
                    const ModuleOptions& options) {
    return "hvi-gen module " + stepper.method.provenance().origin + " " + scene +
           options_for(options.wishes, Command::module) +
           (options.name ? " --name " + options.name->text : "");
}

}  // namespace

void run(const ModuleOptions& options) {
    if (options.name) check_module_name(options.name->text, whole(options.name));
    const MethodAndScene both = read_scene(options.method, options.system);
    const std::string name = options.name ? options.name->text : module_name(both.scene.name);
    const SceneStepper stepper =
        scene_stepper(both.method, both.scene, module_wishes(options.wishes, name));
    check_parameter_of_method(stepper);
    const CModule module = c_module(stepper, name, command(stepper, both.scene.origin, options));

    const InterruptionsHeld held;
    make_directory(options.output);
    const std::filesystem::path header = options.output / (name + ".h");
    const std::filesystem::path source = options.output / (name + ".cpp");
    write_file(header, module.header);
    write_file(source, module.source);
    write_standard_output(header.string() + "\n" + source.string() + "\n");
}

}  // namespace hvi::gen
