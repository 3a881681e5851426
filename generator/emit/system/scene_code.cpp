// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/system/scene_code.hpp"

#include <algorithm>
#include <iterator>
#include <map>

#include "generator/emit/system/class_values.hpp"
#include "generator/emit/system/loop_files.hpp"
#include "generator/emit/system/rotation_code.hpp"
#include "generator/emit/text/constants.hpp"
#include "generator/emit/text/names.hpp"
#include "generator/exact/expressions/evaluate.hpp"
#include "generator/expr/functions.hpp"
#include "generator/read/names.hpp"

namespace hvi::gen {

namespace {

/// A member of Parameters: a number, or an array with the values of m[1], m[2], ...
struct ParameterMember {
    std::string name;  // in C++
    bool is_array;
    std::vector<const SystemParameter*> parameters;
};

std::vector<ParameterMember> members_of(const std::vector<SystemParameter>& parameters) {
    std::vector<ParameterMember> members;
    for (const SystemParameter& parameter : parameters) {
        const std::string base(without_index(parameter.name));
        const bool is_array = base != parameter.name;
        const bool goes_on = is_array && !members.empty() && members.back().is_array &&
                             without_index(members.back().parameters.front()->name) == base;
        if (!goes_on) { members.push_back({member_name(base), is_array, {}}); }
        members.back().parameters.push_back(&parameter);
    }
    return members;
}

void write_parameter(Writer& writer, const ParameterMember& member) {
    const auto line = [&](const SystemParameter& parameter, std::string_view begin,
                          std::string_view end) {
        writer.line("{}{}{}  // {} = {}", begin, initializer(parameter.value), end, parameter.name,
                    to_text(parameter.value));
    };
    if (!member.is_array) {
        line(*member.parameters.front(), fmt::format("Scalar {} = ", member.name), ";");
        return;
    }
    writer.open("std::array<Scalar, {}> {}{{{{", member.parameters.size(), member.name);
    for (const SystemParameter* parameter : member.parameters) { line(*parameter, "", ","); }
    writer.close("}};");
}

/// NOTE: numbers of a file are a member of their own.
void write_table(Writer& writer, const SystemTable& table) {
    const auto* values = std::get_if<std::vector<Expression>>(&table.values);
    if (values == nullptr) { return; }
    writer.open("std::vector<Scalar> {} = hvi::detail::listed<Scalar>({{",
                member_name(table.family.name));
    for (const Expression& value : *values) { writer.line("{},", initializer(value)); }
    writer.close("});");
}

/// What begins at the initial data: a State, where that is not several.
std::string_view state_of_one(const Step& step) {
    return step.layout == Layout::trajectories ? "Trajectory" : "State";
}

/// What H and invariants take of a state x.
struct StateArguments {
    std::string before;  ///< a line, or nothing
    std::string variables;
};

StateArguments arguments_of(const System& system) {
    if (system.is_written_out() && rotations_of(system) > 0) {
        return {"const hvi::detail::ChartState<Space> at = flat(x);", "at.q, at.p"};
    }
    return {"", system.side == Side::lagrangian ? "x.q, velocity(x)" : "x.q, x.p"};
}

void write_member(Writer& writer, std::string_view doc, std::string_view state,
                  std::string_view name, const StateArguments& arguments,
                  std::string_view time = "") {
    writer.comment(doc, "/// ");
    writer.open("[[nodiscard]] Scalar {}(const {}& x) const {{", name, state)
        .insert(arguments.before)
        .line("return system_.{}({}{});", name, arguments.variables, time)
        .close()
        .blank();
}

/// The lines between the declaration of a state x and its return.
std::vector<std::string> lines_of_start(const System& system, std::string_view state) {
    const std::string x = fmt::format("{} x;", state);
    if (!system.is_written_out()) {
        return {x, fmt::format("System(parameters).begin({}x.q, x.p);",
                               begins_in_file(system) ? "parameters, " : "")};
    }
    if (rotations_of(system) > 0) {
        return {"hvi::detail::ChartState<Space> at;", "System::begin(parameters, at.q, at.p);", x,
                "set(x, at);"};
    }
    if (system.side == Side::lagrangian) {
        return {x, "Vector v{};", "System::begin(parameters, x.q, v);",
                fmt::format("System(parameters).dLdv(x.q, v{}, x.p);", system.time ? ", x.t" : "")};
    }
    return {x, "System::begin(parameters, x.q, x.p);"};
}

void write_initial(Writer& writer, const System& system, std::string_view state) {
    const bool is_any_size = !system.is_written_out();
    const bool is_constant =
        !is_any_size && rotations_of(system) == 0 && system.side == Side::hamiltonian;
    const std::string_view constant = is_constant ? "constexpr " : "";
    writer.line("/// Where the scene begins{}.",
                is_any_size ? "; empty where a list does not fit its sizes" : "");
    writer.open("[[nodiscard]] static {}{} initial(const Parameters& parameters) {{", constant,
                state);
    for (const std::string& line : lines_of_start(system, state)) { writer.line("{}", line); }
    writer.line("return x;").close();
    writer.line("[[nodiscard]] static {}{} initial() {{ return initial(Parameters{{}}); }}",
                constant, state);
    writer.blank();
}

/// The velocities of L = v^T M v/2 + a v - U, from M v = p - a, or of the H that was made of L.
void write_velocity(Writer& writer, const System& system, std::string_view state) {
    if (system.is_transformed) {
        writer.line("/// v of p = dL/dv(q, v); empty where x does not have the system's size.");
        writer.open("[[nodiscard]] Vector velocity(const {}& x) const {{", state)
            .line("if (!system_.fits(x.q, x.p)) {{ return {{}}; }}")
            .line("Vector v(x.p.size());")
            .line("system_.dHdp(x.p, v);")
            .line("return v;")
            .close()
            .blank();
        return;
    }
    writer.line("/// v of p = dL/dv(q, v); no numbers where d2L/dv2 is singular.");
    writer.open("[[nodiscard]] Vector velocity(const {}& x) const {{", state)
        .line("return hvi::detail::velocity_of(system_, x.q, x.p{});", system.time ? ", x.t" : "")
        .close()
        .blank();
}

}  // namespace

std::string_view library(const SceneWishes& wishes) {
    return wishes.float128 ? "hvi::math" : "std";
}

std::string_view vector_type(const System& system) {
    if (!system.is_written_out()) { return "std::vector<Number>"; }
    return rotations_of(system) == 0 ? "Numbers" : "typename Space::Vector";
}

bool calls_more_math(const System& system, const SceneWishes& wishes) {
    for (Node node = 0; node < system.graph.size(); ++node) {
        const Computation& computation = system.graph.at(node);
        if (computation.operation != Operation::call) { continue; }
        const Function* const function = find_function(computation.name);
        if (function == nullptr) { continue; }
        const bool is_of_runtime = wishes.float128 || !function->is_smooth();
        if (is_of_runtime && function->runtime == Runtime::more_math) { return true; }
    }
    return false;
}

bool calls_lane_functions(const System& system) {
    constexpr std::string_view without_library[] = {"sin", "cos", "tan"};
    for (Node node = 0; node < system.graph.size(); ++node) {
        const Computation& computation = system.graph.at(node);
        if (computation.operation != Operation::call) { continue; }
        const Function* const function = find_function(computation.name);
        const bool is_needed = function != nullptr && function->nature == Nature::analytic &&
                               std::count(std::begin(without_library), std::end(without_library),
                                          computation.name) == 0;
        if (is_needed) { return true; }
    }
    return false;
}

std::string initializer(const Expression& expression) {
    // NOTE: read again, so that an error points into a text that stands for the number alone.
    const std::string name = to_text(expression);
    const auto text = std::make_shared<const Source>(Source{"number", name});
    const Rounded value = on_new_ground([&](const Ground& ground) {
        return nearest(evaluate_number(parse_expression(text), text, ground));
    });
    return qualified_initializer(Constant{name, value, name});
}

NodeNames parameter_names(const System& system) {
    NodeNames names;
    for (const ParameterMember& member : members_of(system.parameters)) {
        for (std::size_t i = 0; i < member.parameters.size(); ++i) {
            const Node node = member.parameters[i]->node;
            names[node] =
                "parameters." + member.name + (member.is_array ? fmt::format("[{}]", i) : "");
        }
    }
    return names;
}

std::string parameters_text(const System& system) {
    Writer writer(1);
    writer.line("/// As the scene has them.").open("struct Parameters {{");
    if (!system.is_written_out()) {
        for (const SystemSize& size : system.sizes) {
            writer.line("Place {} = {};", member_name(size.name), size.value);
        }
    }
    for (const ParameterMember& member : members_of(system.parameters)) {
        write_parameter(writer, member);
    }
    for (const SystemTable& table : system.tables) { write_table(writer, table); }
    write_numbers_in_files(writer, system);
    return writer.close("};").str();
}

std::string scene_members_text(const System& system, const SceneWishes& wishes, const Step& step) {
    const std::string_view state = state_of_one(step);
    const bool has_velocities = system.side == Side::lagrangian;
    const StateArguments arguments = arguments_of(system);
    const std::string_view unless_it_fits =
        system.is_written_out() ? "" : "; not a number where x does not have the system's size";
    const auto doc = [&](const std::string& text) { return text + std::string(unless_it_fits); };
    Writer writer(1);
    write_reading(writer, system);
    if (!system.initial.empty()) { write_initial(writer, system, state); }
    if (has_velocities || system.is_transformed) { write_velocity(writer, system, state); }
    for (const ClassValue& value : values_of_class(system, wishes)) {
        if (value.about.empty()) { continue; }
        write_member(writer, doc(value.about), state, value.name, arguments,
                     value.has_time ? ", x.t" : "");
    }
    if (wishes.evaluations) {
        writer.line("/// How often d{}/dq was evaluated, at one stage each time.",
                    system.function_letter());
        writer.line(
            "[[nodiscard]] std::int64_t evaluations() const {{ return system_.evaluations; }}");
        writer.blank();
    }
    return writer.str();
}

void check_own_names(const OwnFunctions& own) {
    for (const OwnFunction& function : own.functions) {
        check_own_function_name(function.name, function.place);
    }
}

void check_members(const WrittenOutScene& scene, const SceneWishes& wishes) {
    check_rotation_names(scene);
    std::map<std::string, std::string> bases;
    for (const Parameter& parameter : scene.parameters) {
        const std::string base(without_index(parameter.name));
        const auto [found, is_new] = bases.emplace(member_name(base), base);
        if (is_new || found->second == base) { continue; }
        throw InputError(fmt::format("the parameters `{}` and `{}` would both be the member {} "
                                     "of the header",
                                     found->second, base, found->first),
                         parameter.place, "take another name for one of them");
    }
    if (!wishes.invariants) { return; }
    for (const NamedExpression& invariant : scene.invariants) {
        check_function_name(invariant.name, invariant.place);
    }
}

}  // namespace hvi::gen
