// `hvi-gen list`: names of methods, families, scenes and functions.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "generator/cli/commands.hpp"
#include "generator/cli/rows.hpp"
#include "generator/cli/splits.hpp"
#include "generator/expr/functions.hpp"
#include "generator/read/catalogue.hpp"

namespace hvi::gen {

namespace {

std::string in_brackets(std::string_view paper) {
    return paper.empty() ? "" : fmt::format(" [{}]", paper);
}

TextRows family_rows(std::span<const FamilyEntry> families) {
    TextRows rows;
    for (const FamilyEntry& family : families)
        rows.push_back({fmt::format("{}:S", family.name), fmt::format("S = {}", family.sizes),
                        fmt::format("{}{}", family.description, in_brackets(family.paper))});
    return rows;
}

/// Returns rows of families, then of the forms that are written as calls.
TextRows item_rows(std::span<const FamilyEntry> families, std::span<const FormEntry> forms) {
    TextRows rows = family_rows(families);
    for (const FormEntry& form : forms)
        rows.push_back({std::string(form.form), "", std::string(form.description)});
    return rows;
}

std::string bases() {
    return text_table("Basis functions: --basis", item_rows(basis_families(), basis_forms())) +
           "The largest i of a degree k tells the knots: i+1 B-splines on i+1-k intervals\n"
           "of [0, 1] of equal length; their sum is 1. Any other function of tau: as text.\n";
}

std::string nodes() {
    return text_table("Nodes: --nodes", item_rows(node_families(), node_forms()));
}

std::string methods() {
    TextRows rows;
    for (const MethodEntry& method : named_methods())
        rows.push_back({std::string(method.name),
                        fmt::format("{}{}", method.description, in_brackets(method.paper))});
    TextRows parts;
    for (const SplittingEntry& entry : splittings())
        parts.push_back({std::string(entry.name),
                         entry.sizes.empty() ? "" : fmt::format("S = {}", entry.sizes),
                         fmt::format("{} [{}]", entry.description, entry.source)});
    return text_table("Methods: --method", rows) + "\n" +
           text_table("Splittings of H in parts A + B whose flows are known: --method", parts) +
           "\n" +
           text_table(
               "Methods of S stages, with polynomials that interpolate at the nodes: --method",
               family_rows(node_families()));
}

std::string scene_table() {
    TextRows rows;
    for (const SceneEntry& scene : scenes())
        rows.push_back({std::string(scene.name), scene.description});
    return text_table("Scenes: SCENE, as in hvi-gen scheme --method gauss:2 pendulum", rows);
}

std::string_view text(RealDomain domain) {
    switch (domain) {
    case RealDomain::everywhere: return "";
    case RealDomain::positive: return "x > 0";
    case RealDomain::not_negative: return "x >= 0";
    case RealDomain::up_to_one: return "-1 <= x <= 1";
    case RealDomain::within_one: return "-1 < x < 1";
    case RealDomain::from_one: return "x >= 1";
    }
    HVI_CHECK(false);
    return {};
}

std::vector<std::string> row(const Function& function) {
    if (function.nature == Nature::choice) {
        return {fmt::format("y = {}(a,b)", function.name),
                fmt::format("y = {}", function.derivative)};
    }
    if (function.arguments == 2) {
        return {fmt::format("y = {}(a,b)", function.name),
                fmt::format("dy/da = {}, dy/db = {}", function.derivative, function.by_second)};
    }
    return {fmt::format("y = {}(x)", function.name), fmt::format("y' = {}", function.derivative)};
}

std::string function_table() {
    TextRows rows, others;
    for (const Function& function : functions()) {
        if (is_of_lists(function.name) || is_hidden(function.name)) continue;
        const bool is_analytic_of_one =
            function.nature == Nature::analytic && function.arguments == 1;
        std::vector<std::string> columns = row(function);
        if (is_analytic_of_one) columns.emplace_back(text(function.domain));
        (is_analytic_of_one ? rows : others).push_back(std::move(columns));
    }
    others.push_back({"y = if(a<b,x,y)", "x where a < b, else y; also <=, > and >="});
    return text_table("Functions: in H, in basis functions and in numbers", rows) + "\n" +
           text_table("Functions: in H and in numbers; all but atan2 have kinks", others);
}

}  // namespace

void run(const ListOptions& options) {
    const auto text = [&]() -> std::string {
        switch (options.topic) {
        case Topic::bases: return bases();
        case Topic::nodes: return nodes();
        case Topic::methods: return methods();
        case Topic::scenes: return scene_table();
        case Topic::functions: return function_table();
        case Topic::splits: return splits_of(options.system.value());
        case Topic::all: break;
        }
        return bases() + "\n" + nodes() + "\n" + methods() + "\n" + scene_table() + "\n" +
               function_table();
    };
    write_result({}, text());
}

}  // namespace hvi::gen
