// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/system/start_writer.hpp"

#include <fmt/format.h>

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
        write_values(writer, family, array, {{}, list->values, list->accesses});
    } else if (const auto* points = std::get_if<SystemStart::Points>(&start.values)) {
        write_values(writer, family, array, *points);
    } else if (const auto* rule = std::get_if<SystemStart::Rule>(&start.values)) {
        write_values(writer, family, array, {rule->indices, {rule->value}, rule->accesses});
    } else if (std::holds_alternative<SystemStart::MinusEnergy>(start.values)) {
        writer.line("{}[{}] = -energy(q_of, p_of);", array, place(family, {}));
    } else {
        writer.line("std::copy(parameters.{0}.begin(), parameters.{0}.end(), {1} + {2});",
                    member_of(family.name), array, place(family, {}));
    }
}

/// Returns the place of the element with these indices; indices that are left out have their first
/// value.
std::string StartWriter::place(const SystemFamily& family,
                               const std::vector<std::string>& indices) const {
    std::vector<std::string> all;
    for (const std::string& index : indices) { all.push_back(names_.index(index)); }
    for (std::size_t d = indices.size(); d < family.ranges.size(); ++d) {
        all.push_back("(" + names_.whole(family.ranges[d].first) + ")");
    }
    return ClassNames::place(family, all);
}

/// NOTE: the numbers of a point stand in a row, and so do those of a list.
void StartWriter::write_values(Writer& writer, const SystemFamily& family, std::string_view array,
                               const SystemStart::Points& points) {
    std::vector<Loop> loops;
    for (std::size_t d = 0; d < points.indices.size(); ++d) {
        loops.push_back({points.indices[d], family.ranges[d]});
    }
    loops_.open_loops(writer, loops);
    const Kernel all = kernel(graph_, points.values);
    const NodeNames given = loops_.load(writer, points.accesses, all, loops);
    const auto results = write_code(writer, graph_, all, given, "hvi::math");
    const std::string first = place(family, points.indices);
    if (points.indices.size() == family.ranges.size()) {
        writer.line("{}[{}] = {};", array, first, results.front());
    } else {
        writer.open("const Scalar values[] = {{");
        for (const std::string& result : results) { writer.line("{},", result); }
        writer.close("};").line("hvi::detail::put(values, {} + {});", array, first);
    }
    LoopWriter::close_loops(writer, loops);
}

}  // namespace hvi::gen
