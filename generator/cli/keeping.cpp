// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/keeping.hpp"

#include <optional>

#include "generator/pipeline/split.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

void add_parts(KeepingFacts& facts, const Method& method, const Scene& scene,
               const UnrollWish& sums, const SceneSymmetries& found) {
    if (method.splitting.empty()) return;
    try {
        const LoweredScene system = lowered(scene, sums);
        const std::optional<System> split = system_in_parts(method, system, {});
        if (split) facts.parts = kept_by_parts(*split->parts, *system.written, found);
    } catch (const InputError& error) {
        facts.obstacle = error.what();
    } catch (const MathError& error) { facts.obstacle = error.what(); }
}

}  // namespace hvi::gen
