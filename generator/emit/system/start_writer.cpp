// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/system/start_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "generator/emit/system/element_conditions.hpp"
#include "generator/emit/system/loop_files.hpp"

namespace hvi::gen {

void StartWriter::write(Writer& writer, const StartOfFamilies& /*body*/) {
    const System& system = loops_.system();
    writer.line("q_of.clear();").line("p_of.clear();");
    for (const std::string& condition : conditions_of_starts(system, names_)) {
        writer.line("if (!({})) {{ return; }}", condition);
    }
    write_conditions_of_files(writer, system, names_);
    for (const char letter : {'q', 'p'}) {
        writer.line("{}_of.assign({}, Scalar(0));", letter,
                    letter == 'q' || rotations_of(system) == 0 ? "size_" : "degrees_");
        writer.line("[[maybe_unused]] Scalar* const {0} = {0}_of.data();", letter);
    }
    const std::size_t count = system.coordinates.size();
    for (std::size_t k = 0; k < system.initial.size(); ++k) {
        const bool is_q = k < count;
        write_start(writer, is_q ? system.coordinates[k] : system.conjugates[k - count],
                    is_q ? "q" : "p", system.initial[k]);
    }
}

void StartWriter::write_start(Writer& writer, const SystemFamily& family, std::string_view array,
                              const SystemStart& start) {
    if (const auto* list = std::get_if<SystemStart::List>(&start.values)) {
        write_list(writer, family, array, *list);
    } else if (const auto* rule = std::get_if<SystemStart::Rule>(&start.values)) {
        write_rule(writer, family, array, *rule);
    } else if (const auto* points = std::get_if<SystemStart::Points>(&start.values)) {
        write_points(writer, family, array, *points);
    } else {
        writer.line("std::copy(parameters.{0}.begin(), parameters.{0}.end(), {1} + {2});",
                    member_of(family.name), array, first_place(family));
    }
}

/// Where the element with these indices is.
std::string StartWriter::place(const SystemFamily& family,
                               const std::vector<std::string>& indices) const {
    const std::string name = member_of(family.name);
    std::string text = name + "_at_";
    for (std::size_t d = 0; d < indices.size(); ++d) {
        const bool is_last = d + 1 == indices.size();
        text += is_last ? fmt::format(" + {}", indices[d])
                        : fmt::format(" + {} * {}_step_{}_", indices[d], name, d + 1);
    }
    return text;
}

std::string StartWriter::first_place(const SystemFamily& family) const {
    std::vector<std::string> first;
    for (const LoopRange& range : family.ranges) {
        first.push_back("(" + names_.whole(range.first) + ")");
    }
    return place(family, first);
}

void StartWriter::write_list(Writer& writer, const SystemFamily& family, std::string_view array,
                             const SystemStart::List& list) {
    const Kernel all = kernel(graph_, list.values);
    writer.open("{{");
    const NodeNames given = loops_.load(writer, list.accesses, all, {});
    const auto results = write_code(writer, graph_, all, given, "hvi::math");
    writer.open("const Scalar values[] = {{");
    for (const std::string& result : results) { writer.line("{},", result); }
    writer.close("};");
    writer.line("hvi::detail::put(values, {} + {});", array, first_place(family)).close();
}

/// NOTE: the numbers of a point stand in a row.
void StartWriter::write_points(Writer& writer, const SystemFamily& family, std::string_view array,
                               const SystemStart::Points& points) {
    std::vector<Loop> loops;
    std::vector<std::string> first;
    for (std::size_t d = 0; d < family.ranges.size(); ++d) {
        const bool is_of_body = d < points.indices.size();
        if (is_of_body) { loops.push_back({points.indices[d], family.ranges[d]}); }
        first.push_back(is_of_body ? names_.index(points.indices[d])
                                   : "(" + names_.whole(family.ranges[d].first) + ")");
    }
    if (loops.empty()) { writer.open("{{"); }
    for (const Loop& loop : loops) { loops_.open_loop(writer, loop); }
    const Kernel all = kernel(graph_, points.values);
    const NodeNames given = loops_.load(writer, points.accesses, all, loops);
    const auto results = write_code(writer, graph_, all, given, "hvi::math");
    writer.open("const Scalar values[] = {{");
    for (const std::string& result : results) { writer.line("{},", result); }
    writer.close("};");
    writer.line("hvi::detail::put(values, {} + {});", array, place(family, first));
    for (std::size_t l = 0; l < std::max<std::size_t>(loops.size(), 1); ++l) { writer.close(); }
}

void StartWriter::write_rule(Writer& writer, const SystemFamily& family, std::string_view array,
                             const SystemStart::Rule& rule) {
    std::vector<Loop> loops;
    std::vector<std::string> indices;
    for (std::size_t d = 0; d < rule.indices.size(); ++d) {
        loops.push_back({rule.indices[d], family.ranges[d]});
        indices.push_back(names_.index(rule.indices[d]));
    }
    if (loops.empty()) { writer.open("{{"); }
    for (const Loop& loop : loops) { loops_.open_loop(writer, loop); }
    const Kernel value = kernel(graph_, {rule.value});
    const NodeNames given = loops_.load(writer, rule.accesses, value, loops);
    const auto results = write_code(writer, graph_, value, given, "hvi::math");
    writer.line("{}[{}] = {};", array, place(family, indices), results.front());
    for (std::size_t l = 0; l < std::max<std::size_t>(loops.size(), 1); ++l) { writer.close(); }
}

}  // namespace hvi::gen
