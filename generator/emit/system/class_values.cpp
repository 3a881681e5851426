// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/system/class_values.hpp"

#include "generator/emit/text/names.hpp"

namespace hvi::gen {

std::vector<ClassValue> values_of_class(const System& system, const SceneWishes& wishes) {
    const bool is_lagrangian = system.side == Side::lagrangian;
    const bool has_time = system.time.has_value();
    std::vector<ClassValue> values;
    if (wishes.energy || (wishes.action && !is_lagrangian)) {
        const std::string about =
            is_lagrangian || system.is_transformed
                ? "v dL/dv - L"
                : "H = " + to_text(system.scaled ? system.scaled->energy : system.expression);
        values.push_back({"energy", &system.energy, has_time, wishes.energy ? about : ""});
    }
    if (wishes.action && is_lagrangian) {
        values.push_back({"lagrangian", &system.sums, has_time});
    }
    if (!wishes.invariants) { return values; }
    for (const SystemValue& invariant : system.invariants) {
        values.push_back(
            {member_name(invariant.name), &invariant.sums, false, to_text(invariant.expression)});
    }
    return values;
}

}  // namespace hvi::gen
