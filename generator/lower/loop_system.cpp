// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/loop_system.hpp"

#include <utility>

#include "generator/lower/declarations.hpp"
#include "generator/lower/loop_starts.hpp"
#include "generator/lower/loop_sums.hpp"
#include "generator/lower/loop_time.hpp"

namespace hvi::gen {

System loop_system(const Scene& scene) {
    System system;
    system.side = scene.side;
    system.name = scene.name;
    system.description = scene.description;
    system.directory = scene.directory;
    system.expression = scene.function.written;
    system.own_headers = scene.own.includes();
    Declarations names = declare(system, scene);
    if (scene.scale) { declare_scaled_time(system, names, scene); }
    const IndexedExpression function = names.meant(scene.function, rules_of_function(scene.side));
    system.sums = scene.scale ? sums_of(system, names, function, names.symbols)
                              : sums_in_time(system, names, function);
    if (!scene.scale) { system.initial = starts_of(system, names, scene); }
    for (const NamedIndexed& invariant : scene.invariants) {
        const IndexedExpression meant = names.meant(invariant.expression, invariant_rules);
        system.invariants.push_back({invariant.name, invariant.expression.written,
                                     sums_of(system, names, meant, names.symbols)});
    }
    return scene.scale ? with_scaled_time(std::move(system), names, scene) : system;
}

}  // namespace hvi::gen
