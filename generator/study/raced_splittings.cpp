// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/study/raced_splittings.hpp"

#include <cstddef>
#include <iterator>
#include <variant>

#include "generator/pipeline/split.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

constexpr const char* of_any_parts[] = {"strang", "strang-suzuki:4", "strang-blanes-moan:6",
                                        "strang-kahan-li:8"};
constexpr const char* of_small_parts[] = {"saba:4", "mclachlan:8.4", "blanes:10.6.4"};

/// Returns the number of parts whose flows are the steps of splittings; 0 where there are none.
std::size_t parts_in_steps(const LoweredScene& scene) {
    try {
        const auto split = system_in_parts(named_method(given("--accuracy", "strang")), scene, {});
        return split ? split->parts->parts.size() : 0;
    } catch (const InputError&) { return 0; } catch (const MathError&) {
        return 0;
    }
}

}  // namespace

std::vector<const char*> raced_splittings(const LoweredScene& scene) {
    const std::size_t parts = parts_in_steps(scene);
    if (parts == 0) return {};
    std::vector<const char*> all(std::begin(of_any_parts), std::end(of_any_parts));
    if (parts == 2 && std::holds_alternative<IndexedSplit>(scene.scene.split))
        all.insert(all.end(), std::begin(of_small_parts), std::end(of_small_parts));
    return all;
}

}  // namespace hvi::gen
