// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/module/stepper_part.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <variant>

#include "generator/emit/system/class_names.hpp"
#include "generator/emit/system/scene_code.hpp"
#include "generator/emit/text/names.hpp"
#include "generator/expr/expression.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

/// Returns a whole number made of sizes, as members of `parameters`.
std::string whole(const AffineForm& form) {
    return whole_number(form,
                        [](const std::string& name) { return "parameters." + member_of(name); });
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

/// Whether lists have one index, and equally many values. They may then have more or fewer values.
bool are_equally_long(const std::vector<SystemTable>& tables) {
    return std::all_of(tables.begin(), tables.end(), [&](const SystemTable& table) {
        return table.family.ranges.size() == 1 &&
               element_count(table.family, {}) == element_count(tables.front().family, {});
    });
}

/// Returns the entry of a list; `after` is the number of `tables` after it. A list with one index
/// has the given length: `{"m", hvi::detail::range_of(parameters.m, 1)},`.
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

}  // namespace

bool has_sizes(const System& system) { return vectors_of(system) == StateVectors::any_size; }

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

std::string with_ranges(const SystemFamily& family) {
    std::string ranges;
    const auto size = [](const std::string& name) { return name; };
    for (const LoopRange& range : family.ranges) {
        ranges += fmt::format("{}{}..{}", ranges.empty() ? "" : ",",
                              whole_number(range.first, size), whole_number(range.last, size));
    }
    return family.name + (ranges.empty() ? "" : "[" + ranges + "]");
}

std::vector<ModuleParameter> module_parameters(const System& system) {
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

double value_of_number(const Expression& number) {
    constexpr std::size_t of_double = 1;
    const std::optional<Dyadic> value = rounded_value(number)[of_double];
    HVI_CHECK(value.has_value());  // or the header of the stepper could not be written
    return value->to_double();
}

std::vector<double> values_of_numbers(const System& system) {
    std::vector<double> result;
    if (has_sizes(system)) {
        for (const SystemSize& size : system.sizes) {
            result.push_back(static_cast<double>(size.value));
        }
    }
    for (const SystemParameter& parameter : system.parameters) {
        result.push_back(value_of_number(parameter.value));
    }
    return result;
}

namespace {

/// Returns the statements that read parameters. NOTE: lists at the end may be left out together.
std::string setting(const System& system) {
    Writer writer(2);
    const std::vector<ModuleParameter> all = module_parameters(system);
    const std::size_t first_list = all.size() - system.tables.size();
    for (std::size_t k = 0; k < all.size(); ++k) {
        if (k == first_list) { writer.line("if (reader.is_at_end()) {{ return; }}"); }
        writer.line("{}", all[k].reading);
    }
    return writer.str();
}

std::string values(const System& system) {
    Writer writer(2);
    for (const SystemValue& invariant : system.invariants) {
        writer.line("*out++ = static_cast<double>(stepper.{}(x));", member_of(invariant.name));
    }
    return writer.str();
}

std::string defaults(const System& system) {
    return system.reads_files() ? "Stepper::read_parameters(directory)" : "Parameters{}";
}

constexpr std::string_view once = "#pragma once\n";

}  // namespace

std::string without_once(const std::string& header) {
    const std::size_t begin = header.find(once);
    HVI_CHECK(begin != std::string::npos);
    return header.substr(0, begin) + header.substr(begin + once.size());
}

Holes stepper_holes(const System& system, const std::string& class_name, const std::string& text) {
    return {{"stepper", text},
            {"class", class_name},
            {"defaults", defaults(system)},
            {"threads", has_sizes(system) ? ", threads" : ""},
            {"set", setting(system)},
            {"count", std::to_string(system.invariants.size())},
            {"values", values(system)}};
}

}  // namespace hvi::gen
