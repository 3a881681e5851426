// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/module/module.hpp"

#include <fmt/format.h>

#include <vector>

#include "generator/emit/text/names.hpp"
#include "generator/emit/text/text.hpp"
#include "generator/expr/expression.hpp"
#include "generator/module/stepper_part.hpp"

namespace hvi::gen {

namespace {

std::vector<std::string> names_of(const System& system, const std::vector<Node>& nodes) {
    std::vector<std::string> names;
    for (const Node node : nodes) { names.push_back(system.graph.at(node).name); }
    return names;
}

/// Gives families other names, one for each.
std::vector<SystemFamily> renamed(std::vector<SystemFamily> families,
                                  const std::vector<std::string>& names) {
    for (std::size_t k = 0; k < names.size(); ++k) { families[k].name = names[k]; }
    return families;
}

std::vector<SystemFamily> families(const std::vector<std::string>& names) {
    std::vector<SystemFamily> result;
    for (const std::string& name : names) { result.push_back({name}); }
    return result;
}

/// Returns the coordinates as numbers of a state; those of a written-out system one by one.
std::vector<SystemFamily> coordinates(const System& system) {
    if (!system.is_written_out()) { return system.coordinates; }
    return families(names_of(system, coordinate_nodes(system)));
}

std::vector<SystemFamily> momenta(const System& system) {
    const bool is_lagrangian = system.side == Side::lagrangian;
    if (!system.is_written_out()) {
        return is_lagrangian ? renamed(system.conjugates, system.momenta) : system.conjugates;
    }
    return families(is_lagrangian ? system.momenta : names_of(system, conjugate_nodes(system)));
}

std::string lines(const std::vector<SystemFamily>& families) {
    Writer writer(3);
    for (const SystemFamily& family : families) { writer.line("{}", named_numbers(family)); }
    return writer.str();
}

/// Returns a comment line for each item.
std::string comment_lines(const std::vector<std::string>& items) {
    Writer writer(0);
    for (const std::string& item : items) { writer.comment(item, "//     ", 4); }
    return writer.str();
}

std::string joined(const std::vector<SystemFamily>& families) {
    std::string text;
    for (const SystemFamily& family : families) {
        text += (text.empty() ? "" : ", ") + with_ranges(family);
    }
    return text;
}

std::string names_of_parameters(const System& system) {
    Writer writer(3);
    for (const ModuleParameter& parameter : module_parameters(system)) {
        writer.line("{}", parameter.name);
    }
    return writer.str();
}

std::vector<std::string> described_parameters(const System& system) {
    std::vector<std::string> items;
    for (const ModuleParameter& parameter : module_parameters(system)) {
        items.push_back(parameter.description);
    }
    if (items.empty()) { items.emplace_back("(the scene has none)"); }
    return items;
}

std::vector<std::string> described_state(const System& system) {
    std::vector<std::string> items = {"q: " + joined(coordinates(system)),
                                      "p: " + joined(momenta(system))};
    if (system.time) { items.emplace_back("t"); }
    return items;
}

std::vector<std::string> described_invariants(const System& system) {
    std::vector<std::string> items;
    for (const SystemValue& invariant : system.invariants) {
        items.push_back(fmt::format("{} = {}", invariant.name, to_text(invariant.expression)));
    }
    if (items.empty()) { items.emplace_back("(the scene names none)"); }
    return items;
}

std::string about(const SceneStepper& stepper) {
    Writer writer(0);
    const System& system = stepper.system;
    writer.comment(fmt::format("A stepper of the scene {} with {}.{}{}", system.name,
                               stepper.method.title(), system.description.empty() ? "" : " ",
                               system.description));
    const Iteration* iteration = stepper.step.iteration();
    if (iteration != nullptr && iteration->counts_sweeps()) {
        writer.comment(fmt::format("Its steps are explicit, of exactly {} sweep{} each: symplectic "
                                   "up to the last change alone.",
                                   iteration->sweeps, iteration->sweeps == 1 ? "" : "s"));
    }
    return writer.str();
}

std::string comment(const std::string& text) {
    Writer writer(0);
    writer.comment(text, "//     ", 4);
    return writer.str();
}

std::string source_of(const SceneStepper& stepper, const std::string& name,
                      const std::string& command) {
    const System& system = stepper.system;
    std::vector<std::string> invariants;
    for (const SystemValue& each : system.invariants) { invariants.push_back(each.name); }
    Holes holes = stepper_holes(system, stepper.class_name, without_once(stepper.header));
    holes.merge(Holes{{"command", comment(command)},
                      {"name", name},
                      {"parameters", names_of_parameters(system)},
                      {"coordinates", lines(coordinates(system))},
                      {"momenta", lines(momenta(system))},
                      {"invariants", lines(families(invariants))}});
    return fill("module.cpp.in", holes);
}

}  // namespace

StepperWishes module_wishes(StepperWishes wishes, const std::string& name) {
    wishes.energy = wishes.invariants = wishes.evaluations = true;
    wishes.class_name = given("--name", class_name(name));
    return wishes;
}

CModule c_module(const SceneStepper& stepper, const std::string& name, const std::string& command) {
    const System& system = stepper.system;
    const std::string example = coordinates(system).front().name;
    return {fill("module.h.in", {{"command", comment(command)},
                                 {"about", about(stepper)},
                                 {"name", name},
                                 {"guard", "HVI_MODULE_" + name},
                                 {"parameters", comment_lines(described_parameters(system))},
                                 {"state", comment_lines(described_state(system))},
                                 {"example", example},
                                 {"invariants", comment_lines(described_invariants(system))}}),
            source_of(stepper, name, command)};
}

}  // namespace hvi::gen
