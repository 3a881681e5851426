// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/splits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "generator/cli/method.hpp"
#include "generator/cli/rows.hpp"
#include "generator/pipeline/split.hpp"
#include "generator/plan/flow_step.hpp"
#include "generator/render/layout.hpp"
#include "generator/symmetry/watched.hpp"

namespace hvi::gen {

namespace {

/// Names of quantities that the same parts keep.
using KeptTogether = std::vector<std::pair<std::string, std::string>>;

void add(KeptTogether& all, const std::string& what, const std::string& name) {
    const auto place =
        std::find_if(all.begin(), all.end(), [&](const auto& each) { return each.first == what; });
    if (place == all.end()) {
        all.emplace_back(what, name);
    } else {
        place->second += ", " + name;
    }
}

void add(KeptTogether& all, const KeptByParts& kept, const BracketsWithParts& brackets,
         const std::string& name) {
    const std::string refuted = names_of_parts(kept, brackets, Vanishing::refuted);
    const std::string unknown = names_of_parts(kept, brackets, Vanishing::unknown);
    if (is_kept_by_all(brackets)) add(all, "kept by each part: ", name);
    if (!refuted.empty()) add(all, fmt::format("not kept by {}: ", refuted), name);
    if (!unknown.empty()) add(all, fmt::format("not seen of {}: ", unknown), name);
}

/// Returns lines on what the flow of each part keeps: momentum maps that no invariant tells,
/// invariants and the energy.
std::string kept_text(const System& split, Scene scene) {
    const Watched watched = watch(scene, {Unroll::yes, "list splits"});
    if (!watched.found)
        return watched.left_out.empty() ? ""
                                        : "symmetries not looked for: " + watched.left_out + "\n";
    const KeptByParts kept = kept_by_parts(*split.parts, unrolled(scene), *watched.found);
    const std::vector<const ConservedQuantity*> quantities = quantities_of(*watched.found);
    KeptTogether all;
    for (std::size_t i = 0; i < quantities.size(); ++i) {
        const ConservedQuantity& each = *quantities[i];
        const bool is_map = each.kind == ConservedQuantity::Kind::momentum_map;
        if (!each.is_said)
            add(all, kept, kept.brackets[i], is_map ? to_text(each.expression) : each.name);
    }
    if (!watched.found->depends_on_time) add(all, kept, kept.brackets.back(), "energy");
    std::string text;
    for (const auto& [what, names] : all)
        for (const std::string& line : wrapped(what, names)) text += line + "\n";
    return text;
}

std::size_t flows_of_strang(const HamiltonianParts& split) {
    const Number half = Number(1) / Number(2);
    return flow_step(split.parts.size(), split.small_steps, {half, half}).flows();
}

/// Returns a table of the ways to take H apart, with a mark for the one that is taken.
std::string candidates_text(const std::vector<SplitCandidate>& candidates, std::size_t chosen) {
    TextRows rows{{"", "parts", "flows", "operations", "error/h^2", "work"}};
    for (std::size_t k = 0; k < candidates.size(); ++k) {
        const SplitCandidate& each = candidates[k];
        const std::size_t flows = flows_of_strang(*each.system.parts);
        rows.push_back({k == chosen ? "*" : "", each.name, fmt::format("{}", flows),
                        fmt::format("{:.0f}", each.cost),
                        each.error ? fmt::format("{:.1e}", *each.error) : "",
                        each.error ? fmt::format("{:.1e}", each.work()) : ""});
    }
    return text_table("Steps of strang in a row, and the error of the energy along the motion:", rows);
}

std::string parts_text(const System& split, const Scene& scene) {
    TextRows rows;
    for (const HamiltonianPart& part : split.parts->parts)
        rows.push_back({part.name, part.flow, text_of(part)});
    const bool is_named = std::holds_alternative<IndexedSplit>(scene.split);
    const auto* choice = std::get_if<SplitChoice>(&scene.split);
    const bool has_orbits = choice != nullptr && is_of_orbits(*choice);
    std::string text =
        text_table(fmt::format("Parts of H of {}, {}: their flows are exact", title(scene),
                               is_named     ? "as [split] names them"
                               : has_orbits ? fmt::format("with {} orbits", word_of(*choice))
                                            : "as found among its terms"),
                   rows);
    if (has_orbits)
        text += *choice == SplitChoice::jacobi
                    ? "Q_j: body j from the centre of mass of those before it\n"
                    : "Q_j: body j from the first one; P_j: its momentum as the centre sees it\n";
    return text;
}

/// Returns what is told of the steps of strang.
std::string strang_text(const HamiltonianParts& split, const std::string& scene) {
    const SmallSteps& small = split.small_steps;
    const std::size_t flows = flows_of_strang(split);
    std::string text;
    if (small.exist())
        text = fmt::format("the first {} are fast: they take {} small steps in a large one\n",
                           small.parts, small.count);
    return text +
           fmt::format("strang takes {} flow{} a step, as in hvi-gen run --method strang {}\n",
                       flows, flows == 1 ? "" : "s", scene);
}

}  // namespace

std::string splits_of(const SystemOptions& system) {
    const Scene scene = read_scene_alone({}, system);
    const LoweredScene system_of_scene = lowered(scene, {Unroll::yes, "list splits"});
    std::vector<SplitCandidate> candidates = ways_to_split(system_of_scene);
    measure(candidates, *system_of_scene.written);
    const std::size_t chosen = chosen_split(candidates);
    const System& split = candidates[chosen].system;
    std::string text = parts_text(split, scene) + kept_text(split, scene);
    // NOTE: the measure is that of steps without small ones.
    if (!split.parts->small_steps.exist()) text += candidates_text(candidates, chosen);
    text += strang_text(*split.parts, scene.origin);
    const bool is_asked_for = !std::holds_alternative<std::monostate>(scene.split);
    const bool is_kicked = is_separable(split) && rotations_of(split) == 0;
    if (is_kicked && !is_asked_for)
        text +=
            "H is T(p) + U(q): without --split auto splittings step these by drifts and kicks\n";
    return text;
}

}  // namespace hvi::gen
