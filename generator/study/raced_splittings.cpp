// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/study/raced_splittings.hpp"

#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>
#include <variant>

#include "generator/pipeline/split.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

constexpr const char* of_any_parts[] = {"strang", "strang-suzuki:4", "strang-blanes-moan:6",
                                        "strang-kahan-li:8"};
constexpr const char* of_small_parts[] = {"saba:4", "mclachlan:8.4", "blanes:10.6.4"};

/// Returns the parts whose flows are the steps of splittings, where there are any.
std::optional<HamiltonianParts> parts_in_steps(const LoweredScene& scene) {
    try {
        auto split = system_in_parts(named_method(given("--accuracy", "strang")), scene, {});
        return split ? std::move(split->parts) : std::nullopt;
    } catch (const InputError&) { return {}; } catch (const MathError&) {
        return {};
    }
}

/// Returns whether a scene says that the second of its parts is small: its own two, or what
/// disturbs orbits.
bool has_small_part(const LoweredScene& scene, const HamiltonianParts& parts) {
    const auto* choice = std::get_if<SplitChoice>(&scene.scene.split);
    if (choice != nullptr) return is_of_orbits(*choice);
    return parts.parts.size() == 2 && std::holds_alternative<IndexedSplit>(scene.scene.split) &&
           !parts.small_steps.exist();
}

}  // namespace

std::vector<const char*> raced_splittings(const LoweredScene& scene) {
    const std::optional<HamiltonianParts> parts = parts_in_steps(scene);
    if (!parts) return {};
    std::vector<const char*> all(std::begin(of_any_parts), std::end(of_any_parts));
    if (has_small_part(scene, *parts))
        all.insert(all.end(), std::begin(of_small_parts), std::end(of_small_parts));
    return all;
}

}  // namespace hvi::gen
