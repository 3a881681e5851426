// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/module/module.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <variant>
#include <vector>

#include "generator/emit/steps/emit.hpp"
#include "generator/emit/system/class_names.hpp"
#include "generator/emit/system/scene_code.hpp"
#include "generator/emit/text/names.hpp"
#include "generator/emit/text/text.hpp"
#include "generator/expr/expression.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

/// A whole number of sizes, as members of `parameters`.
std::string whole(const AffineForm& form) {
    return whole_number(form,
                        [](const std::string& name) { return "parameters." + member_of(name); });
}

/// `{"q", {{1, parameters.N}}},`
std::string named_numbers(const SystemFamily& family) {
    std::string ranges;
    for (const LoopRange& range : family.ranges) {
        ranges += fmt::format("{}{{{}, {}}}", ranges.empty() ? "" : ", ", whole(range.first),
                              whole(range.last));
    }
    const std::string name = text_literal(family.name);
    return ranges.empty() ? fmt::format("{{{}}},", name)
                          : fmt::format("{{{}, {{{}}}}},", name, ranges);
}

std::vector<std::string> names_of(const System& system, const std::vector<Node>& nodes) {
    std::vector<std::string> names;
    for (const Node node : nodes) { names.push_back(system.graph.at(node).name); }
    return names;
}

/// Families with the names of others, which has one for each.
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

/// Coordinates as numbers of a state: of a system that is written out one by one.
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

bool has_sizes(const System& system) { return vectors_of(system) == StateVectors::any_size; }

std::string values(const System& system) {
    Writer writer(2);
    for (const SystemValue& invariant : system.invariants) {
        writer.line("*out++ = static_cast<double>(stepper.{}(x));", member_of(invariant.name));
    }
    return writer.str();
}

/// A comment line for each of these.
std::string comment_lines(const std::vector<std::string>& items) {
    Writer writer(0);
    for (const std::string& item : items) { writer.comment(item, "//     ", 4); }
    return writer.str();
}

/// `m[1..N]`
std::string with_ranges(const SystemFamily& family) {
    std::string ranges;
    const auto size = [](const std::string& name) { return name; };
    for (const LoopRange& range : family.ranges) {
        ranges += fmt::format("{}{}..{}", ranges.empty() ? "" : ",",
                              whole_number(range.first, size), whole_number(range.last, size));
    }
    return family.name + (ranges.empty() ? "" : "[" + ranges + "]");
}

std::string joined(const std::vector<SystemFamily>& families) {
    std::string text;
    for (const SystemFamily& family : families) {
        text += (text.empty() ? "" : ", ") + with_ranges(family);
    }
    return text;
}

std::string default_of(const SystemTable& table) {
    if (const auto* file = std::get_if<NumbersInFile>(&table.values)) {
        return "from the file " + file->path;
    }
    std::string text;
    for (const Expression& value : std::get<std::vector<Expression>>(table.values)) {
        text += (text.empty() ? "" : ", ") + to_text(value);
    }
    return text;
}

/// A parameter of a module in the three places where its text has it.
struct ModuleParameter {
    std::string reading;      ///< the statement that gives it a value
    std::string name;         ///< and its ranges, as an initialiser
    std::string description;  ///< with its default
};

/// Whether lists have one index, and as many values as each other: then they may have more or less.
bool are_equally_long(const std::vector<SystemTable>& tables) {
    return std::all_of(tables.begin(), tables.end(), [&](const SystemTable& table) {
        return table.family.ranges.size() == 1 &&
               element_count(table.family, {}) == element_count(tables.front().family, {});
    });
}

/// A list, after which there are so many of `tables`. Where it has one index it is as long as it is
/// given: `{"m", hvi::detail::range_of(parameters.m, 1)},`.
ModuleParameter list(const SystemTable& table, const std::vector<SystemTable>& tables,
                     std::size_t after) {
    const std::string member = "parameters." + member_of(table.family.name);
    const std::string count = are_equally_long(tables)
                                  ? fmt::format("reader.share({})", after + 1)
                                  : std::to_string(element_count(table.family, {}));
    std::string name = named_numbers(table.family);
    if (table.family.ranges.size() == 1) {
        name =
            fmt::format("{{{}, hvi::detail::range_of({}, {})}},", text_literal(table.family.name),
                        member, whole(table.family.ranges.front().first));
    }
    return {fmt::format("reader.list({}, {});", member, count), std::move(name),
            fmt::format("{} = {}", with_ranges(table.family), default_of(table))};
}

/// Parameters in their order: sizes, numbers, lists.
std::vector<ModuleParameter> parameters(const System& system) {
    std::vector<ModuleParameter> result;
    if (has_sizes(system)) {
        for (const SystemSize& size : system.sizes) {
            result.push_back({fmt::format("reader.size(parameters.{});", member_of(size.name)),
                              named_numbers({size.name}),
                              fmt::format("{} = {}", size.name, size.value)});
        }
    }
    const NodeNames names = parameter_names(system);
    for (const SystemParameter& parameter : system.parameters) {
        result.push_back({fmt::format("reader.number({});", names.at(parameter.node)),
                          named_numbers({parameter.name}),
                          fmt::format("{} = {}", parameter.name, to_text(parameter.value))});
    }
    for (std::size_t k = 0; k < system.tables.size(); ++k) {
        const std::size_t after = system.tables.size() - k - 1;
        result.push_back(list(system.tables[k], system.tables, after));
    }
    return result;
}

/// Statements that read parameters. NOTE: lists at the end may be left out together.
std::string setting(const System& system) {
    Writer writer(2);
    const std::vector<ModuleParameter> all = parameters(system);
    const std::size_t first_list = all.size() - system.tables.size();
    for (std::size_t k = 0; k < all.size(); ++k) {
        if (k == first_list) { writer.line("if (reader.is_at_end()) {{ return; }}"); }
        writer.line("{}", all[k].reading);
    }
    return writer.str();
}

std::string names_of_parameters(const System& system) {
    Writer writer(3);
    for (const ModuleParameter& parameter : parameters(system)) {
        writer.line("{}", parameter.name);
    }
    return writer.str();
}

std::vector<std::string> described_parameters(const System& system) {
    std::vector<std::string> items;
    for (const ModuleParameter& parameter : parameters(system)) {
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
    return writer.str();
}

constexpr std::string_view once = "#pragma once\n";

/// NOTE: the header is a part of another file, which is not included.
std::string without_once(const std::string& header) {
    const std::size_t begin = header.find(once);
    HVI_CHECK(begin != std::string::npos);
    return header.substr(0, begin) + header.substr(begin + once.size());
}

std::string defaults(const System& system) {
    return system.reads_files() ? "Stepper::read_parameters(directory)" : "Parameters{}";
}

std::string comment(const std::string& text) {
    Writer writer(0);
    writer.comment(text, "//     ", 4);
    return writer.str();
}

}  // namespace

StepperWishes module_wishes(StepperWishes wishes, const std::string& name) {
    wishes.energy = wishes.invariants = wishes.evaluations = true;
    wishes.class_name = given("--name", class_name(name));
    return wishes;
}

namespace {

/// Holes that both kinds of modules have for their stepper; `text` is that of its class.
Holes stepper_holes(const System& system, const std::string& class_name, const std::string& text) {
    return {{"stepper", text},
            {"class", class_name},
            {"defaults", defaults(system)},
            {"threads", has_sizes(system) ? ", threads" : ""},
            {"set", setting(system)},
            {"count", std::to_string(system.invariants.size())},
            {"values", values(system)}};
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

/// The system with other values in their places.
System without_values(System system) {
    for (SystemParameter& parameter : system.parameters) { parameter.value = {}; }
    for (SystemSize& size : system.sizes) { size.value = 1; }
    return system;
}

/// NOTE: what stands above is for people who read the header.
std::string code_of(const std::string& header) { return header.substr(header.find(once)); }

}  // namespace

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

std::string driven_module(const SceneStepper& stepper) {
    const System system = without_values(stepper.system);
    const std::string header =
        emit(stepper.method, stepper.step,
             {.class_name = stepper.class_name,
              .command = "",
              .system = &system,
              .wishes = stepper.members,
              .evaluations = stepper.evaluations ? &*stepper.evaluations : nullptr});
    return fill("driven.cpp.in",
                stepper_holes(system, stepper.class_name, without_once(code_of(header))));
}

std::vector<double> driven_parameters(const System& system) {
    std::vector<double> result;
    if (has_sizes(system)) {
        for (const SystemSize& size : system.sizes) {
            result.push_back(static_cast<double>(size.value));
        }
    }
    for (const SystemParameter& parameter : system.parameters) {
        constexpr std::size_t of_double = 1;
        const std::optional<Dyadic> value = rounded_value(parameter.value)[of_double];
        HVI_CHECK(value.has_value());  // or the header of the stepper could not be written
        result.push_back(value->to_double());
    }
    return result;
}

}  // namespace hvi::gen
