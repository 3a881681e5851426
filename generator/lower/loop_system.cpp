// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/loop_system.hpp"

#include <utility>

#include "generator/lower/declarations.hpp"
#include "generator/lower/loop_starts.hpp"
#include "generator/lower/loop_sums.hpp"
#include "generator/read/names.hpp"

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
    system.sums = sums_in_time(system, names, scene.function);
    system.initial = starts_of(system, names, scene);
    for (const NamedIndexed& invariant : scene.invariants) {
        check_parameter_name(invariant.name, invariant.place_of_name, "an invariant");
        names.take(invariant.name, invariant.place_of_name);
        system.invariants.push_back({invariant.name, invariant.expression.written,
                                     sums_of(system, names, invariant.expression, names.symbols)});
    }
    return system;
}

}  // namespace hvi::gen
