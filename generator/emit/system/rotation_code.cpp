// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/system/rotation_code.hpp"

#include <fmt/format.h>

#include <map>
#include <utility>
#include <vector>

#include "generator/emit/text/names.hpp"
#include "generator/emit/text/text.hpp"
#include "generator/read/names.hpp"

namespace hvi::gen {

namespace {

/// A member: R, or an array of R[1], R[2], ...
struct Member {
    std::string name;       // in C++
    std::size_t count = 0;  // size of an array; 0 for a single one
};

/// Members and their elements by their names in C++: `x.R`, or `x.R[1]`.
struct RotationMembers {
    std::vector<Member> rotations, momenta;
    std::vector<std::string> each_rotation, each_momentum;  ///< in the order of the system
};

void add(std::vector<Member>& members, std::vector<std::string>& each, const std::string& name) {
    const std::string base(without_index(name));
    const std::string member = member_name(base);
    if (base == name) {
        members.push_back({member, 0});
        each.push_back(member);
        return;
    }
    if (members.empty() || members.back().name != member) { members.push_back({member, 0}); }
    each.push_back(fmt::format("{}[{}]", member, members.back().count++));
}

RotationMembers members_of(const System& system) {
    RotationMembers result;
    for (std::size_t k = flat_coordinates(system); k < system.coordinates.size(); ++k) {
        add(result.rotations, result.each_rotation, system.coordinates[k].name);
        add(result.momenta, result.each_momentum, system.conjugates[k].name);
    }
    return result;
}

/// Returns `{1, 0, ...}`, or an array of them.
std::string initial(const Member& member, std::string_view one) {
    if (member.count == 0) { return fmt::format("{{{}}}", one); }
    std::string all;
    for (std::size_t i = 0; i < member.count; ++i) {
        all += fmt::format("{}{{{{{}}}}}", all.empty() ? "" : ", ", one);
    }
    return fmt::format("{{{{{}}}}}", all);
}

void declare(Writer& writer, const Member& member, std::size_t numbers, std::string_view one) {
    const std::string type = fmt::format("std::array<Scalar, {}>", numbers);
    writer.line("{} {}{};",
                member.count == 0 ? type : fmt::format("std::array<{}, {}>", type, member.count),
                member.name, initial(member, one));
}

void write_structs(Writer& writer, const System& system, const RotationMembers& members) {
    constexpr std::string_view identity = "1, 0, 0, 0, 1, 0, 0, 0, 1";
    const std::size_t n = flat_coordinates(system);
    writer.comment("Where bodies are: coordinates q, and rotations from body to space, row by row.",
                   "/// ");
    writer.open("struct Placement {{");
    if (n > 0) { writer.line("std::array<Scalar, {}> q{{}};", n); }
    for (const Member& member : members.rotations) {
        declare(writer, member, rotations_of_space.point, identity);
    }
    writer.close("};").blank();
    writer.comment("A placement with momenta p, and angular momenta in the bodies.", "/// ");
    writer.open("struct Bodies : Placement {{");
    if (n > 0) { writer.line("std::array<Scalar, {}> p{{}};", n); }
    for (const Member& member : members.momenta) {
        declare(writer, member, angular_momenta.point, "0, 0, 0");
    }
    if (system.time) { writer.line("Scalar t = 0;"); }
    writer.close("};").blank();
}

/// Writes copies in one direction or the other.
void write_copies(Writer& writer, const System& system, const RotationMembers& members,
                  bool with_momenta, bool is_inward) {
    const std::size_t n = flat_coordinates(system);
    const auto copy = [&](std::size_t count, const std::string& outer, const std::string& inner) {
        writer.line("for (std::size_t k = 0; k < {}; ++k) {{ {} = {}; }}", count,
                    is_inward ? inner : outer, is_inward ? outer : inner);
    };
    const auto copy_all = [&](const std::vector<std::string>& names, std::size_t numbers,
                              std::string_view vector) {
        for (std::size_t r = 0; r < names.size(); ++r) {
            copy(numbers, fmt::format("x.{}[k]", names[r]),
                 fmt::format("{}[{} + k]", vector, n + numbers * r));
        }
    };
    const std::string_view q = with_momenta ? "at.q" : "q", p = "at.p";
    if (n > 0) { copy(n, "x.q[k]", fmt::format("{}[k]", q)); }
    copy_all(members.each_rotation, rotations_of_space.point, q);
    if (!with_momenta) { return; }
    if (n > 0) { copy(n, "x.p[k]", fmt::format("{}[k]", p)); }
    copy_all(members.each_momentum, angular_momenta.point, p);
}

}  // namespace

std::string bodies_text(const System& system) {
    const RotationMembers members = members_of(system);
    Writer writer(1);
    write_structs(writer, system, members);
    writer.line("/// As the numbers q, then R, and p, then L, one after the other.");
    writer.open("[[nodiscard]] static hvi::detail::ChartState<Space> flat(const Bodies& x) {{");
    writer.line("hvi::detail::ChartState<Space> at;");
    write_copies(writer, system, members, true, true);
    writer.line("return at;").close().blank();
    writer.line("/// Sets x to these.");
    writer.open("static void set(Bodies& x, const hvi::detail::ChartState<Space>& at) {{");
    write_copies(writer, system, members, true, false);
    writer.close().blank();
    writer.line("/// Sets the placement x to q, then R, one after the other.");
    writer.open("static void set(Placement& x, const typename Space::Positions& q) {{");
    write_copies(writer, system, members, false, false);
    return writer.close().str();
}

void check_rotation_names(const WrittenOutScene& scene) {
    const MechanicalFunction& function = function_of(scene);
    if (function.rotations.empty()) { return; }
    std::map<std::string, std::string> taken{{"q", ""}, {"p", ""}, {"t", ""}};
    const auto look = [&](const std::string& name) {
        const std::string base(without_index(name));
        const auto [found, is_new] = taken.emplace(member_name(base), base);
        if (is_new || found->second == base) { return; }
        throw InputError(
            fmt::format("`{}` is called as another member of the state of a stepper", base),
            whole(function.source),
            "the state has members q, p and t, and one for each rotation and angular "
            "momentum: take another name");
    };
    for (const RotationNames& names : function.rotations) {
        look(names.rotation);
        look(names.momentum);
    }
}

}  // namespace hvi::gen
