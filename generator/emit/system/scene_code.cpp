// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/system/scene_code.hpp"

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

void write_parameter(Writer& writer, const ParameterMember& member, std::string_view array) {
    const auto line = [&](const SystemParameter& parameter, std::string_view begin,
                          std::string_view end) {
        writer.line("{}{}{}  // {} = {}", begin, initializer(parameter.value), end, parameter.name,
                    to_text(parameter.value));
    };
    if (!member.is_array) {
        line(*member.parameters.front(), fmt::format("Scalar {} = ", member.name), ";");
        return;
    }
    writer.open("{}<Scalar, {}> {}{{{{", array, member.parameters.size(), member.name);
    for (const SystemParameter* parameter : member.parameters) { line(*parameter, "", ","); }
    writer.close("}};");
}

/// Writes a table of parameters. NOTE: numbers of a file are a member of their own.
void write_table(Writer& writer, const SystemTable& table) {
    const auto* values = std::get_if<std::vector<Expression>>(&table.values);
    if (values == nullptr) { return; }
    writer.open("std::vector<Scalar> {} = hvi::detail::listed<Scalar>({{",
                member_name(table.family.name));
    for (const Expression& value : *values) { writer.line("{},", initializer(value)); }
    writer.close("});");
}

/// Returns the type of one state: State, or Trajectory where a State holds several.
std::string_view state_of_one(const Step& step) {
    return step.layout == Layout::trajectories ? "Trajectory" : "State";
}

/// Returns the System of one state in the stepper.
std::string_view system_of_one(const Step& step) {
    return step.layout == Layout::trajectories ? "one_" : "system_";
}

/// Forms of a state x in members of the stepper.
struct StateForm {
    std::string variables;                        ///< arguments of functions of System
    std::vector<std::string> start;               ///< lines from the declaration of x to its return
    std::string before = {};                      ///< a line before `variables`, or empty
    std::string_view constant = {};               ///< a qualifier before `start`
    std::string_view empty = {}, no_number = {};  ///< when x is empty, and when values are NaN
};

StateForm form_of(const System& system, std::string_view state) {
    const std::string x = fmt::format("{} x;", state);
    switch (vectors_of(system)) {
    case StateVectors::any_size:
        return {.variables = "x.q, x.p",
                .start = {x, fmt::format("System(parameters).begin({}x.q, x.p);",
                                         begins_in_file(system) ? "parameters, " : "")},
                .empty = "; empty where a list does not fit its sizes",
                .no_number = "; not a number where x does not have the system's size"};
    case StateVectors::bodies:
        return {.variables = "at.q, at.p",
                .start = {"hvi::detail::ChartState<Space> at;",
                          "System::begin(parameters, at.q, at.p);", x, "set(x, at);"},
                .before = "const hvi::detail::ChartState<Space> at = flat(x);"};
    case StateVectors::numbers: break;
    }
    if (system.side == Side::hamiltonian) {
        return {.variables = "x.q, x.p",
                .start = {x, "System::begin(parameters, x.q, x.p);"},
                .constant = "constexpr "};
    }
    return {.variables = "x.q, velocity(x)",
            .start = {x, "Vector v{};", "System::begin(parameters, x.q, v);",
                      fmt::format("System(parameters).dLdv(x.q, v{}, x.p);",
                                  system.time ? ", x.t" : "")}};
}

void write_member(Writer& writer, const ClassValue& value, const Step& step,
                  const StateForm& form) {
    writer.comment(value.about + std::string(form.no_number), "/// ");
    writer.open("[[nodiscard]] Scalar {}(const {}& x) const {{", value.name, state_of_one(step))
        .insert(form.before)
        .line("return {}.{}({}{});", system_of_one(step), value.name, form.variables,
              value.has_time ? ", x.t" : "")
        .close();
    if (step.layout == Layout::trajectories) {
        writer.open("[[nodiscard]] typename State::Lane {}(const State& x) const {{", value.name)
            .line("return system_.{}(hvi::detail::load(x.q), hvi::detail::load(x.p){});",
                  value.name, value.has_time ? ", x.clock.start()" : "")
            .close();
    }
    writer.blank();
}

void write_initial(Writer& writer, std::string_view state, const StateForm& form) {
    writer.line("/// Where the scene begins{}.", form.empty);
    writer.open("[[nodiscard]] static {}{} initial(const Parameters& parameters) {{", form.constant,
                state);
    for (const std::string& line : form.start) { writer.line("{}", line); }
    writer.line("return x;").close();
    writer.line("[[nodiscard]] static {}{} initial() {{ return initial(Parameters{{}}); }}",
                form.constant, state);
    writer.blank();
}

/// Writes the velocities of L = v^T M v/2 + a v - U, from M v = p - a, or those of the H that was
/// made of L.
void write_velocity(Writer& writer, const System& system, const Step& step) {
    const std::string_view state = state_of_one(step);
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
        .line("return hvi::detail::velocity_of({}, x.q, x.p{});", system_of_one(step),
              system.time ? ", x.t" : "")
        .close()
        .blank();
}

}  // namespace

std::string_view library(const SceneWishes& wishes) {
    return wishes.float128 ? "hvi::math" : "std";
}

StateVectors vectors_of(const System& system) {
    if (!system.is_written_out()) { return StateVectors::any_size; }
    return rotations_of(system) == 0 ? StateVectors::numbers : StateVectors::bodies;
}

std::string_view vector_type(const System& system) {
    switch (vectors_of(system)) {
    case StateVectors::numbers: return "Numbers";
    case StateVectors::bodies: return "typename Space::Vector";
    case StateVectors::any_size: return "std::vector<Number>";
    }
    HVI_CHECK(false);
    return {};
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

Rounded rounded_value(const Expression& expression) {
    // NOTE: read again, so that an error points into a text that stands for the number alone.
    const auto text = std::make_shared<const Source>(Source{"number", to_text(expression)});
    return on_new_ground([&](const Ground& ground) {
        return nearest(evaluate_number(parse_expression(text), text, ground));
    });
}

std::string device_initializer(const Expression& expression) {
    const Rounded value = rounded_value(expression);
    const auto& [single, twice, extended, quadruple] = value;
    HVI_CHECK(twice);
    if (single == twice) { return fmt::format("Scalar({})", literal(twice->to_double())); }
    return fmt::format("hvi::device::constant<Scalar>({}, {})",
                       literal(single ? static_cast<float>(single->to_double()) : 0.0F),
                       literal(twice->to_double()));
}

std::string initializer(const Expression& expression) {
    const std::string name = to_text(expression);
    return qualified_initializer(Constant{name, rounded_value(expression), name});
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

std::string parameters_text(const System& system, const Step& step) {
    const bool are_threads = step.layout == Layout::threads;
    Writer writer(1);
    writer.line("/// As the scene has them.").open("struct Parameters {{");
    if (vectors_of(system) == StateVectors::any_size) {
        for (const SystemSize& size : system.sizes) {
            writer.line("Place {} = {};", member_name(size.name), size.value);
        }
    }
    for (const ParameterMember& member : members_of(system.parameters)) {
        write_parameter(writer, member, are_threads ? "hvi::device::Vector" : "std::array");
    }
    for (const SystemTable& table : system.tables) { write_table(writer, table); }
    write_numbers_in_files(writer, system);
    return writer.close("};").str();
}

std::string scene_members_text(const System& system, const SceneWishes& wishes, const Step& step) {
    const std::string_view state = state_of_one(step);
    const StateForm form = form_of(system, state);
    Writer writer(1);
    write_reading(writer, system);
    if (!system.initial.empty()) { write_initial(writer, state, form); }
    if (system.side == Side::lagrangian || system.is_transformed) {
        write_velocity(writer, system, step);
    }
    for (const ClassValue& value : values_of_class(system, wishes)) {
        if (!value.about.empty()) { write_member(writer, value, step, form); }
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
