// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/split_choice.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "generator/lower/parts.hpp"

namespace hvi::gen {

namespace {

constexpr double clearly_less = 0.9;
constexpr std::size_t most_measured = 24;  ///< degrees of freedom: second derivatives are squares

/// Returns the system with its parts in reverse, under the names of their new places.
System in_reverse(System system) {
    std::vector<HamiltonianPart>& parts = system.parts.value().parts;
    std::reverse(parts.begin(), parts.end());
    std::optional<std::size_t>& clock = system.parts->clock;
    if (clock) clock = parts.size() - 1 - *clock;
    for (std::size_t k = 0; k < parts.size(); ++k) parts[k].name = name_of_part(k);
    return system;
}

/// Returns whether each part is of q alone or of p alone, so that it is a part of T and U.
bool are_kicks_and_drifts(const System& system) {
    const std::vector<HamiltonianPart>& parts = system.parts.value().parts;
    return parts.size() <= 2 && std::all_of(parts.begin(), parts.end(), [&](const auto& part) {
               const Roles roles = system.graph.at(part.value.node).roles;
               return !has(roles, Role::coordinate) || !has(roles, Role::conjugate);
           });
}

}  // namespace

double SplitCandidate::work() const { return cost * std::sqrt(error.value()); }

std::vector<SplitCandidate> split_candidates(const System& system, const WrittenOutScene& scene) {
    std::vector<SplitCandidate> all;
    const auto add = [&](const char* name, System parts) {
        all.push_back({name, std::move(parts)});
    };
    System found = with_parts(system, scene);
    const bool has_others =
        is_separable(system) && rotations_of(system) == 0 && !are_kicks_and_drifts(found);
    add(scene.split ? "as named" : "in order", std::move(found));
    if (!scene.split && all.front().system.parts->parts.size() > 1)
        add("in reverse", in_reverse(all.front().system));
    if (!scene.split && moves_forms(*all.front().system.parts)) {
        System others = with_parts(system, scene, FoundParts::without_matrices);
        if (!moves_forms(*others.parts) ||
            others.parts->parts.size() != all.front().system.parts->parts.size()) {
            add("no matrix", others);
            add("no matrix, in reverse", in_reverse(std::move(others)));
        }
    }
    if (!scene.split && has_others) {
        add("T(p), U(q)", with_parts(system, scene, FoundParts::kinetic_potential));
        add("U(q), T(p)", in_reverse(all.back().system));
    }
    return all;
}

void measure(std::vector<SplitCandidate>& all, const WrittenOutScene& scene) {
    for (SplitCandidate& each : all) each.cost = cost_of_strang(each.system);
    const System& first = all.front().system;
    if (first.time || first.degrees_of_freedom() > most_measured) return;
    if (first.parts->parts.size() < 2) return;
    const auto states = states_of_motion(first, scene);
    if (!states) return;
    for (SplitCandidate& each : all) each.error = split_error(each.system, scene, *states);
}

std::size_t chosen_split(const std::vector<SplitCandidate>& candidates) {
    const bool are_known = std::all_of(candidates.begin(), candidates.end(),
                                       [](const auto& each) { return each.error.has_value(); });
    if (!are_known) return 0;
    const auto best = std::min_element(
        candidates.begin(), candidates.end(),
        [](const auto& left, const auto& right) { return left.work() < right.work(); });
    const bool is_clear = best->work() < clearly_less * candidates.front().work();
    return is_clear ? static_cast<std::size_t>(best - candidates.begin()) : 0;
}

}  // namespace hvi::gen
