// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/system/loop_files.hpp"

#include <algorithm>
#include <utility>

namespace hvi::gen {

namespace {

std::string place_of(const NumbersInFile& file) {
    const std::string path = text_literal(file.path);
    return file.column.empty() ? path
                               : fmt::format("column {} of {}", text_literal(file.column), path);
}

/// A member of Parameters that is read from a file.
struct NumbersMember {
    const SystemFamily* family;  ///< parameters, or variables with these initial values
    NumbersInFile file;
};

/// Returns the members, grouped by file: each file is read once.
std::vector<std::pair<std::string, std::vector<NumbersMember>>>
by_file(const std::vector<NumbersMember>& members) {
    std::vector<std::pair<std::string, std::vector<NumbersMember>>> result;
    for (const NumbersMember& member : members) {
        const auto same = std::find_if(result.begin(), result.end(), [&](const auto& of) {
            return of.first == member.file.path;
        });
        if (same == result.end()) {
            result.push_back({member.file.path, {member}});
        } else {
            same->second.push_back(member);
        }
    }
    return result;
}

/// Returns the variables whose initial values are in files.
std::vector<NumbersMember> starts_in_files(const System& system) {
    std::vector<NumbersMember> result;
    const std::size_t count = system.coordinates.size();
    for (std::size_t k = 0; k < system.initial.size(); ++k) {
        const SystemFamily& family =
            k < count ? system.coordinates[k] : system.conjugates[k - count];
        if (const auto* file = std::get_if<NumbersInFile>(&system.initial[k].values)) {
            result.push_back({&family, *file});
        }
    }
    return result;
}

/// Returns the parameters in files, then the initial values in files.
std::vector<NumbersMember> numbers_in_files(const System& system) {
    std::vector<NumbersMember> result;
    for (const SystemTable& table : system.tables) {
        if (const auto* file = std::get_if<NumbersInFile>(&table.values)) {
            result.push_back({&table.family, *file});
        }
    }
    for (const NumbersMember& start : starts_in_files(system)) { result.push_back(start); }
    return result;
}

}  // namespace

void write_numbers_in_files(Writer& writer, const System& system) {
    for (const NumbersMember& member : numbers_in_files(system)) {
        writer.line("std::vector<Scalar> {}{{}};  // {}", member_of(member.family->name),
                    place_of(member.file));
    }
}

void write_reading(Writer& writer, const System& system) {
    if (!system.reads_files()) { return; }
    writer.comment("Parameters{} with the numbers that stand in files, whose paths are relative to "
                   "`directory`. Throws std::runtime_error, with the line, where one is not there "
                   "or has no such numbers.",
                   "/// ");
    writer.open("[[nodiscard]] static Parameters read_parameters(const std::string& directory) {{");
    writer.line("Parameters parameters;");
    for (const auto& [path, columns] : by_file(numbers_in_files(system))) {
        writer.line("hvi::detail::read_columns<Scalar>(directory, {}, {{", text_literal(path));
        for (const NumbersMember& member : columns) {
            writer.line("    {{{}, &parameters.{}}},", text_literal(member.file.column),
                        member_of(member.family->name));
        }
        writer.line("}});");
    }
    writer.line("return parameters;").close().blank();
}

bool begins_in_file(const System& system) { return !starts_in_files(system).empty(); }

void write_conditions_of_files(Writer& writer, const System& system, const ClassNames& names) {
    for (const NumbersMember& start : starts_in_files(system)) {
        writer.open("if (static_cast<Place>(parameters.{}.size()) != {}) {{",
                    member_of(start.family->name), names.count(*start.family));
        writer.line("return;").close();
    }
}

std::string include_of_files(const System& system) {
    if (!system.reads_files()) { return ""; }
    return "#include <hvi/detail/loops/column_files.hpp>\n";
}

}  // namespace hvi::gen
