// `hvi-gen list`: names of methods, families, scenes and functions.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "generator/cli/commands.hpp"
#include "generator/cli/method.hpp"
#include "generator/expr/functions.hpp"
#include "generator/pipeline/split.hpp"
#include "generator/plan/flow_step.hpp"
#include "generator/read/catalogue.hpp"
#include "generator/read/written_out_scene.hpp"

namespace hvi::gen {

namespace {

using Rows = std::vector<std::vector<std::string>>;

/// Formats rows under a title, in columns as wide as they need to be.
std::string table(std::string_view title, const Rows& rows) {
    std::vector<std::size_t> widths(rows.front().size());
    for (const auto& row : rows)
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());

    std::string text = fmt::format("{}\n", title);
    for (const auto& row : rows) {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i)
            line += fmt::format("  {:<{}}", row[i], widths[i]);
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + "\n";
    }
    return text;
}

std::string in_brackets(std::string_view paper) {
    return paper.empty() ? "" : fmt::format(" [{}]", paper);
}

Rows family_rows(std::span<const FamilyEntry> families) {
    Rows rows;
    for (const FamilyEntry& family : families)
        rows.push_back({fmt::format("{}:S", family.name), fmt::format("S = {}", family.sizes),
                        fmt::format("{}{}", family.description, in_brackets(family.paper))});
    return rows;
}

/// Returns rows of families, then of the forms that are written as calls.
Rows item_rows(std::span<const FamilyEntry> families, std::span<const FormEntry> forms) {
    Rows rows = family_rows(families);
    for (const FormEntry& form : forms)
        rows.push_back({std::string(form.form), "", std::string(form.description)});
    return rows;
}

std::string bases() {
    return table("Basis functions: --basis", item_rows(basis_families(), basis_forms())) +
           "The largest i of a degree k tells the knots: i+1 B-splines on i+1-k intervals\n"
           "of [0, 1] of equal length; their sum is 1. Any other function of tau: as text.\n";
}

std::string nodes() { return table("Nodes: --nodes", item_rows(node_families(), node_forms())); }

std::string methods() {
    Rows rows;
    for (const MethodEntry& method : named_methods())
        rows.push_back({std::string(method.name),
                        fmt::format("{}{}", method.description, in_brackets(method.paper))});
    Rows parts;
    for (const SplittingEntry& entry : splittings())
        parts.push_back({std::string(entry.name),
                         entry.sizes.empty() ? "" : fmt::format("S = {}", entry.sizes),
                         fmt::format("{} [{}]", entry.description, entry.source)});
    return table("Methods: --method", rows) + "\n" +
           table("Splittings of H in parts A + B whose flows are known: --method", parts) + "\n" +
           table("Methods of S stages, with polynomials that interpolate at the nodes: --method",
                 family_rows(node_families()));
}

std::string scene_table() {
    Rows rows;
    for (const SceneEntry& scene : scenes())
        rows.push_back({std::string(scene.name), scene.description});
    return table("Scenes: SCENE, as in hvi-gen scheme --method gauss:2 pendulum", rows);
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
    Rows rows, others;
    for (const Function& function : functions()) {
        if (is_of_lists(function.name) || is_hidden(function.name)) continue;
        const bool is_analytic_of_one =
            function.nature == Nature::analytic && function.arguments == 1;
        std::vector<std::string> columns = row(function);
        if (is_analytic_of_one) columns.emplace_back(text(function.domain));
        (is_analytic_of_one ? rows : others).push_back(std::move(columns));
    }
    others.push_back({"y = if(a<b,x,y)", "x where a < b, else y; also <=, > and >="});
    return table("Functions: in H, in basis functions and in numbers", rows) + "\n" +
           table("Functions: in H and in numbers; all but atan2 have kinks", others);
}

/// Returns what is told of the steps of strang.
std::string strang_text(const HamiltonianParts& split, const std::string& scene) {
    const SmallSteps& small = split.small_steps;
    const Number half = Number(1) / Number(2);
    const std::size_t flows = flow_step(split.parts.size(), small, {half, half}).flows();
    std::string text;
    if (small.exist())
        text = fmt::format("the first {} are fast: they take {} small steps in a large one\n",
                           small.parts, small.count);
    return text +
           fmt::format("strang takes {} flow{} a step, as in hvi-gen run --method strang {}\n",
                       flows, flows == 1 ? "" : "s", scene);
}

/// Returns what is told of the parts of a scene's H, and of their flows.
std::string split_table(const SystemOptions& system) {
    const Scene scene = read_scene_alone({}, system);
    const System split = in_parts(lowered(scene, {Unroll::yes, "list splits"}));
    Rows rows;
    for (const HamiltonianPart& part : split.parts->parts)
        rows.push_back({part.name, part.flow, to_text(part.expression)});
    const bool is_named = std::holds_alternative<IndexedSplit>(scene.split);
    const auto* choice = std::get_if<SplitChoice>(&scene.split);
    const bool has_orbits = choice != nullptr && is_of_orbits(*choice);
    std::string text =
        table(fmt::format("Parts of H of {}, {}: their flows are exact", title(scene),
                          is_named     ? "as [split] names them"
                          : has_orbits ? fmt::format("with {} orbits", word_of(*choice))
                                       : "as found among its terms"),
              rows);
    if (has_orbits)
        text += *choice == SplitChoice::jacobi
                    ? "Q_j: body j from the centre of mass of those before it\n"
                    : "Q_j: body j from the first one; P_j: its momentum as the centre sees it\n";
    text += strang_text(*split.parts, scene.origin);
    const bool is_kicked = is_separable(split) && rotations_of(split) == 0;
    if (is_kicked && !is_named && !has_orbits)
        text +=
            "H is T(p) + U(q): without --split auto splittings step these by drifts and kicks\n";
    return text;
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
        case Topic::splits: return split_table(options.system.value());
        case Topic::all: break;
        }
        return bases() + "\n" + nodes() + "\n" + methods() + "\n" + scene_table() + "\n" +
               function_table();
    };
    write_result({}, text());
}

}  // namespace hvi::gen
