// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/ir/loop_system.hpp"

#include <algorithm>

namespace hvi::gen {

const LoopFamily& LoopSystem::family(const Access& access) const {
    switch (access.kind) {
    case FamilyKind::coordinate:
    case FamilyKind::direction: return coordinates.at(access.family);
    case FamilyKind::momentum: return momenta.at(access.family);
    case FamilyKind::table: break;
    }
    return tables.at(access.family).family;
}

bool LoopSystem::is_separable() const {
    return std::all_of(sums.begin(), sums.end(), [](const LoopSum& sum) {
        return sum.by_q.empty() || sum.by_momenta.empty();
    });
}

bool LoopSystem::reads_files() const {
    const auto in_file = [](const auto& of) {
        return std::holds_alternative<NumbersInFile>(of.values);
    };
    return std::any_of(tables.begin(), tables.end(), in_file) ||
           std::any_of(initial.begin(), initial.end(), in_file);
}

}  // namespace hvi::gen
