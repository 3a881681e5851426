// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/pipeline/any_size.hpp"

#include <utility>

#include "generator/lower/system.hpp"
#include "generator/read/no_loops.hpp"

namespace hvi::gen {

namespace {

/// Writes out what loops do not have, where there is a choice.
void look_for_obstacles(UnrollDecision& decision, const Scene& scene, const UnrollWish& wish) {
    if (decision.writes_out || !may_write_out(scene, wish.choice)) { return; }
    try {
        static_cast<void>(system_of(scene));
    } catch (const NoLoops& obstacle) { decision = {true, obstacle.what()}; }
}

}  // namespace

SceneOfAnySize find_scene_of_any_size(const Given& name_or_file,
                                      const std::vector<Parameter>& values,
                                      const UnrollWish& wish) {
    Scene written = find_indexed_scene(name_or_file, values);
    UnrollDecision decision = unroll_decision(written, wish);
    look_for_obstacles(decision, written, wish);
    if (!decision.writes_out) { return {std::move(written), std::move(decision)}; }
    return {written_out(written, name_or_file, decision.why), std::move(decision)};
}

}  // namespace hvi::gen
