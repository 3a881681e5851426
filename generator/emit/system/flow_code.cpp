// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/system/flow_code.hpp"

#include <vector>

#include "generator/emit/system/class_names.hpp"

namespace hvi::gen {

namespace {

/// Writes the call: all changes first, from values before the flow, then what they move.
std::string call_text(const System& system, const HamiltonianPart& part, ClassNames& names,
                      std::string_view library) {
    std::vector<Scaled> changes;
    for (const Moved& moved : part.moved) { changes.push_back(moved.change); }
    const Kernel code = kernel(system.graph, std::move(changes));
    Writer writer(2);
    writer.line("template <class Path>").open("void operator()(Path& at) const {{");
    writer.line("[[maybe_unused]] const auto& q = at.x.q;");
    writer.line("[[maybe_unused]] const auto& p = at.x.p;");
    const std::vector<std::string> values =
        write_code(writer, system.graph, code, names.given(code, variable_names(system)), library);
    for (std::size_t k = 0; k < values.size(); ++k) {
        writer.line("const Scalar change_{} = {};", k + 1, values[k]);
    }
    for (std::size_t k = 0; k < values.size(); ++k) {
        const Moved& moved = part.moved[k];
        writer.line("at.move_{}({}, change_{});", moved.is_conjugate ? 'p' : 'q', moved.component,
                    k + 1);
    }
    return writer.close().str();
}

}  // namespace

std::string flow_text(const System& system, std::size_t part, std::string_view library) {
    const HamiltonianParts& parts = *system.parts;
    const HamiltonianPart& it = parts.parts[part];
    const std::string name = fmt::format("Flow{}", part + 1);
    ClassNames names(system, Constants::are_numbers);
    names.add_input(parts.duration, "time");
    const std::string call = call_text(system, it, names, library);
    Writer setup(2), data(2);
    names.write_setup(setup, library);
    names.write_data(data);
    Writer writer(1);
    writer.comment(fmt::format("Flow of the part {} = {} of H over a time: {}.", it.name,
                               to_text(it.expression), it.flow),
                   "/// ");
    writer.open("struct {} {{", name).line("{}() = default;", name);
    writer.open(
        "{}([[maybe_unused]] const Parameters& parameters, [[maybe_unused]] Scalar time) {{", name);
    writer.insert(setup.str()).close().blank();
    writer.insert(call);
    if (!data.str().empty()) { writer.blank().insert(data.str()); }
    return writer.close("};").str();
}

}  // namespace hvi::gen
