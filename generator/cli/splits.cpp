// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/splits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "generator/cli/method.hpp"
#include "generator/cli/rows.hpp"
#include "generator/pipeline/split.hpp"
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
    add(all, kept, kept.brackets.back(), "energy");
    std::string text;
    for (const auto& [what, names] : all)
        for (const std::string& line : wrapped(what, names)) text += line + "\n";
    return text;
}

/// Returns a table of the ways to take H apart, with a mark for the one that is taken.
std::string candidates_text(const std::vector<SplitCandidate>& candidates, std::size_t chosen) {
    TextRows rows{{"", "parts", "flows", "operations", "error/h^2", "work"}};
    for (std::size_t k = 0; k < candidates.size(); ++k) {
        const SplitCandidate& each = candidates[k];
        const std::size_t flows = 2 * each.system.parts->parts.size() - 1;
        rows.push_back({k == chosen ? "*" : "", each.name, fmt::format("{}", flows),
                        fmt::format("{:.0f}", each.cost),
                        each.error ? fmt::format("{:.1e}", *each.error) : "",
                        each.error ? fmt::format("{:.1e}", each.work()) : ""});
    }
    return text_table("Steps of strang, and the error of the energy along the motion:", rows);
}

std::string parts_text(const System& split, const Scene& scene) {
    TextRows rows;
    for (const HamiltonianPart& part : split.parts->parts)
        rows.push_back({part.name, part.flow, to_text(part.expression)});
    const bool is_named = std::holds_alternative<IndexedSplit>(scene.split);
    return text_table(fmt::format("Parts of H of {}, {}: their flows are exact", title(scene),
                                  is_named ? "as [split] names them" : "as found among its terms"),
                      rows);
}

}  // namespace

std::string splits_of(const SystemOptions& system) {
    const Scene scene = read_scene_alone({}, system);
    const LoweredScene system_of_scene = lowered(scene, {Unroll::yes, "list splits"});
    std::vector<SplitCandidate> candidates = ways_to_split(system_of_scene);
    measure(candidates, *system_of_scene.written);
    const std::size_t chosen = chosen_split(candidates);
    const System& split = candidates[chosen].system;
    const std::size_t flows = 2 * split.parts->parts.size() - 1;
    std::string text =
        parts_text(split, scene) + kept_text(split, scene) + candidates_text(candidates, chosen);
    text += fmt::format("strang takes {} flow{} a step, as in hvi-gen run --method strang {}\n",
                        flows, flows == 1 ? "" : "s", scene.origin);
    const bool is_asked_for = !std::holds_alternative<std::monostate>(scene.split);
    const bool is_kicked = is_separable(split) && rotations_of(split) == 0;
    if (is_kicked && !is_asked_for)
        text +=
            "H is T(p) + U(q): without --split auto splittings step these by drifts and kicks\n";
    return text;
}

}  // namespace hvi::gen
