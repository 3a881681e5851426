// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/system/size_members.hpp"

#include <fmt/format.h>

#include "generator/emit/system/element_conditions.hpp"

namespace hvi::gen {

namespace {

std::vector<const SystemFamily*> all_families(const System& system) {
    std::vector<const SystemFamily*> families;
    for (const auto* each : {&system.coordinates, &system.conjugates}) {
        for (const SystemFamily& family : *each) { families.push_back(&family); }
    }
    for (const SystemTable& table : system.tables) { families.push_back(&table.family); }
    return families;
}

}  // namespace

std::vector<std::string> SizeMembers::initialised() const {
    std::vector<std::string> members;
    for (const SystemSize& size : system_.sizes) {
        members.push_back(fmt::format("{0}_(parameters.{0})", member_of(size.name)));
    }
    for (const SystemTable& table : system_.tables) {
        members.push_back(fmt::format("{0}_values_(parameters.{0})", member_of(table.family.name)));
    }
    if (has_chunks_) { members.emplace_back("team_(threads)"); }
    return members;
}

void SizeMembers::write_places(Writer& writer, const SystemFamily& family,
                               std::string_view total) const {
    const std::string name = member_of(family.name);
    const std::size_t d = family.ranges.size();
    std::string first;
    for (std::size_t i = d; i-- > 0;) {
        if (i + 1 < d) {
            writer.line("{}_step_{}_ = {}{};", name, i + 1, names_.count(family.ranges[i + 1]),
                        i + 2 < d ? fmt::format(" * {}_step_{}_", name, i + 2) : "");
        }
        first += fmt::format(" - ({}){}", names_.whole(family.ranges[i].first),
                             i + 1 < d ? fmt::format(" * {}_step_{}_", name, i + 1) : "");
    }
    writer.line("{}_at_ = {}{};", name, total.empty() ? "0" : total, first);
    if (total.empty()) { return; }
    std::string count = d == 0 ? "1" : names_.count(family.ranges[0]);
    if (d > 1) { count += fmt::format(" * {}_step_1_", name); }
    writer.line("{} += {};", total, count);
}

/// Writes the conditions on sizes. NOTE: for other sizes than those of the scene.
void SizeMembers::write_fits(Writer& writer) const {
    for (const SystemTable& table : system_.tables) {
        if (table.family.ranges.size() == 1) { continue; }
        long count = 1;
        for (const LoopRange& range : table.family.ranges) { count *= range.last.constant; }
        writer.line("fits_ = fits_ && {}_values_.size() == {};", member_of(table.family.name),
                    count);
    }
    for (const std::string& condition : conditions_of_sums(system_, names_)) {
        writer.line("fits_ = fits_ && {};", condition);
    }
}

void SizeMembers::write_setup(Writer& writer) const {
    writer.line("Place in_q = 0, in_p = 0;");
    for (const SystemFamily& family : system_.coordinates) { write_places(writer, family, "in_q"); }
    for (const SystemFamily& family : system_.conjugates) { write_places(writer, family, "in_p"); }
    for (const SystemTable& table : system_.tables) { write_places(writer, table.family, ""); }
    writer.line("size_ = static_cast<std::size_t>(in_q);");
    if (rotations_of(system_) > 0) { writer.line("degrees_ = static_cast<std::size_t>(in_p);"); }
    if (system_.sites) { writer.line("count_ = in_q / {};", system_.coordinates.size()); }
    write_fits(writer);
}

void SizeMembers::write_data(Writer& writer) const {
    for (const SystemSize& size : system_.sizes) {
        writer.line("Place {}_;", member_of(size.name));
    }
    for (const SystemTable& table : system_.tables) {
        writer.line("Vector {}_values_;", member_of(table.family.name));
    }
    for (const SystemFamily* family : all_families(system_)) {
        const std::string name = member_of(family->name);
        std::string line = fmt::format("Place {}_at_ = 0", name);
        for (std::size_t d = 1; d < family->ranges.size(); ++d) {
            line += fmt::format(", {}_step_{}_ = 0", name, d);
        }
        writer.line("{};", line);
    }
    writer.line("std::size_t size_ = 0;").line("bool fits_ = true;");
    if (rotations_of(system_) > 0) {
        writer.line("std::size_t degrees_ = 0;  // of freedom");
        writer.line("mutable Vector by_entries_{{}};  // dH/dq, and by the entries of rotations");
    }
    if (system_.sites) { writer.line("Place count_ = 0;  // of sites"); }
    if (has_chunks_) {
        writer.line("mutable hvi::detail::Team team_;");
        writer.line("mutable Vector memory_{{}};  // of chunks");
    }
}

}  // namespace hvi::gen
