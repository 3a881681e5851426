// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/taken_names.hpp"

namespace hvi::gen {

std::set<std::string> taken_names(const System& system) {
    std::set<std::string> taken{"t"};
    for (const SystemSize& size : system.sizes) { taken.insert(size.name); }
    for (const SystemParameter& each : system.parameters) { taken.insert(each.name); }
    for (const SystemTable& table : system.tables) { taken.insert(table.family.name); }
    for (const SystemFamily& family : system.coordinates) { taken.insert(family.name); }
    for (const SystemFamily& family : system.conjugates) { taken.insert(family.name); }
    taken.insert(system.momenta.begin(), system.momenta.end());
    const auto add_indices = [&](const std::vector<SystemSum>& sums) {
        for (const SystemSum& sum : sums) {
            for (const Loop& loop : sum.loops) { taken.insert(loop.index); }
        }
    };
    add_indices(system.sums);
    for (const SystemTotal& total : system.totals) { add_indices(total.sums); }
    for (const SystemValue& invariant : system.invariants) {
        taken.insert(invariant.name);
        add_indices(invariant.sums);
    }
    return taken;
}

std::string new_name(std::string name, std::set<std::string>& taken) {
    while (!taken.insert(name).second) { name += '_'; }
    return name;
}

}  // namespace hvi::gen
