// `hvi-gen stepper`: a method as a C++ header.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cstdio>
#include <memory>

#include "generator/cli/commands.hpp"
#include "generator/cli/method.hpp"
#include "generator/emit/emit.hpp"
#include "generator/emit/names.hpp"
#include "generator/plan/plan.hpp"

namespace hvi::gen {

namespace {

void check_name(const std::string& name) {
    check_class_name(
        name, Place{std::make_shared<const Source>(Source{"--name", name}), {0, name.size()}});
}

/// The command that writes the same header again, wherever to.
std::string command(const Tableau& tableau, const StepperOptions& options) {
    std::string text = "hvi-gen stepper " + tableau.origin;
    if (options.separable) text += " --separable";
    if (options.name) text += " --name " + *options.name;
    return text;
}

}  // namespace

void run(const StepperOptions& options) {
    if (options.name) check_name(*options.name);
    const Tableau tableau = tableau_of(options.method);
    const Scheme scheme = plan(tableau, {.separable = options.separable});
    const EmitOptions emitted = {.class_name = options.name.value_or(class_name(tableau.name)),
                                 .command = command(tableau, options)};
    const std::string header = emit(tableau, scheme, emitted);
    if (options.explain) std::fputs(dump(scheme).c_str(), stderr);
    write_result(options.output, header);
}

}  // namespace hvi::gen
