// The class System of a scene.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <set>

#include "generator/emit/system/class_values.hpp"
#include "generator/emit/system/given_names.hpp"
#include "generator/emit/system/loop_code.hpp"
#include "generator/emit/system/scene_code.hpp"
#include "generator/emit/text/names.hpp"

namespace hvi::gen {

namespace {

using Results = std::vector<Scaled>;

/// The template parameter that vectors are of.
constexpr std::string_view vector_type(bool are_lanes) { return are_lanes ? "Values" : "Vector"; }

/// The names of variables in functions.
NodeNames variable_names(const System& system) {
    NodeNames names;
    const auto add = [&](const std::vector<Node>& nodes, char letter) {
        for (std::size_t k = 0; k < nodes.size(); ++k) {
            names[nodes[k]] = fmt::format("{}[{}]", letter, k);
        }
    };
    add(coordinate_nodes(system), 'q');
    add(conjugate_nodes(system), system.conjugate_letter());
    if (system.time) { names[*system.time] = "t"; }
    return names;
}

/// A function of (q, p), or of one of them; on the Lagrangian side of (q, v).
struct SystemFunction {
    std::string name;
    std::vector<std::string> targets;  ///< of the results; empty where the only one is returned
    Kernel kernel;
    bool has_q = true, has_p = true;  ///< among its arguments
    std::string out = {};             ///< its last argument, if any
    bool is_matrix = false;           ///< of a type that a caller chooses
    bool has_time = false;            ///< among its arguments, before that
    bool is_mirrored = false;         ///< out is a matrix of which the lower half is computed
    NodeNames names = {};             ///< of what it alone is given
    bool has_forces = false;          ///< dH/dq at a stage
    bool is_counted = false;          ///< each call
    bool takes_lanes = false;         ///< as well as numbers
    bool is_inlined = false;          ///< wherever it is called
};

bool uses_any(const Kernel& kernel, const std::vector<Node>& nodes) {
    return std::any_of(nodes.begin(), nodes.end(),
                       [&](Node node) { return kernel.uses[node] != 0; });
}

/// `const Vector& q`, marked where the function does not look at it.
std::string argument(bool is_used, std::string_view type_and_name) {
    return fmt::format("{}{}", is_used ? "" : "[[maybe_unused]] ", type_and_name);
}

std::vector<std::string> components(std::string_view letter, std::size_t count) {
    std::vector<std::string> names;
    for (std::size_t k = 0; k < count; ++k) { names.push_back(fmt::format("{}[{}]", letter, k)); }
    return names;
}

SystemFunction hessian(std::string name, const BlockKernel& block) {
    SystemFunction function;
    function.name = std::move(name);
    function.out = "Matrix& out";
    function.is_matrix = true;
    for (const auto& [row, column] : block.places) {
        function.targets.push_back(fmt::format("out({}, {})", row, column));
        function.is_mirrored = function.is_mirrored || (block.is_symmetric && row != column);
    }
    function.kernel = block.kernel;
    return function;
}

/// Without what a separable H does not look at.
SystemFunction of_positions(SystemFunction function, const Step& step) {
    function.has_p = !step.is_separable();
    function.has_time = step.depends_on_time();
    return function;
}

SystemFunction of_momenta(SystemFunction function, const Step& step) {
    function.has_q = !step.is_separable();
    function.has_time = step.depends_on_time() && !step.is_separable();
    return function;
}

/// Adds what iterations evaluate beside slopes.
void add_second_derivatives(std::vector<SystemFunction>& functions, const SecondDerivatives& second,
                            const System& system, const Step& step) {
    const auto name = [&](std::string_view variables) {
        std::string text = fmt::format("d2{}{}", system.function_letter(), variables);
        std::replace(text.begin(), text.end(), 'p', system.conjugate_letter());
        return text;
    };
    if (second.qq) { functions.push_back(of_positions(hessian(name("dq2"), *second.qq), step)); }
    if (second.mixed) {
        functions.push_back(of_momenta(hessian(name("dqdp"), *second.mixed), step));
    }
    if (second.conjugates) {
        functions.push_back(of_momenta(hessian(name("dp2"), *second.conjugates), step));
    }
}

/// Adds constant terms of second derivatives, as functions of nothing.
void add_constant_terms(std::vector<SystemFunction>& functions, const SecondDerivatives& constant) {
    const auto add = [&](std::string name, const std::optional<BlockKernel>& block) {
        if (!block) { return; }
        functions.push_back(hessian(std::move(name), *block));
        functions.back().has_q = functions.back().has_p = false;
    };
    add("constant_d2Hdq2", constant.qq);
    add("constant_d2Hdqdp", constant.mixed);
    add("constant_d2Hdp2", constant.conjugates);
}

/// Adds dH/dq that keeps what it shares with qq v, the tangent at q, and qq v that takes it.
void add_tangents(std::vector<SystemFunction>& functions, const Tangents& tangents,
                  const System& system) {
    const std::vector<Node>& direction = system.structure.direction;
    const std::vector<std::string> out = components("out", direction.size());
    const std::vector<std::string> kept = components("at", tangents.kept.size());
    SystemFunction along{"d2Hdq2", out, tangents.along, true, false};
    SystemFunction slope{"dHdq", out, tangents.slope, true, false};
    slope.has_forces = true;
    slope.has_time = system.time.has_value();
    slope.targets.insert(slope.targets.end(), kept.begin(), kept.end());
    for (std::size_t k = 0; k < direction.size(); ++k) {
        along.names[direction[k]] = fmt::format("v[{}]", k);
    }
    for (std::size_t k = 0; k < kept.size(); ++k) { along.names[tangents.kept[k]] = kept[k]; }
    slope.out = "Vector& out, " + argument(!kept.empty(), "Tangent& at");
    along.out = argument(!kept.empty(), "const Tangent& at") + ", " +
                argument(uses_any(along.kernel, direction), "const Vector& v") + ", Vector& out";
    functions.push_back(std::move(slope));
    functions.push_back(std::move(along));
}

/// Adds dH/dq that keeps what dH/dp at the same q takes of it, and that dH/dp.
void add_shared(std::vector<SystemFunction>& functions, const Kernel& by_q_and_shared,
                const GradientKernels& gradients, const System& system, const Step& step) {
    const std::vector<std::string> out = components("out", system.degrees_of_freedom());
    const std::vector<std::string> kept = components("at", gradients.shared.size());
    SystemFunction by_q{"dHdq", out, by_q_and_shared, true, true, "Values& out, Values& at"};
    by_q.has_forces = true;
    SystemFunction by_p{"dHdp", out,  gradients.by_conjugates_at_q,
                        true,   true, "const Values& at, Values& out"};
    by_q.targets.insert(by_q.targets.end(), kept.begin(), kept.end());
    for (std::size_t k = 0; k < kept.size(); ++k) { by_p.names[gradients.shared[k]] = kept[k]; }
    for (SystemFunction* function : {&by_q, &by_p}) {
        function->has_time = step.depends_on_time();
        function->takes_lanes = true;
        functions.push_back(std::move(*function));
    }
}

/// NOTE: no lane lives through a call, and g++ calls what a composition needs twenty times. Where
/// there is much, the call does not matter; and of several sin inlined into a loop the constants
/// are kept in registers, which are then wanted for other things.
bool is_inlined(const Kernel& kernel, const Step& step) {
    constexpr std::size_t small = 32;
    const std::size_t most_calls = step.layout == Layout::stages ? 1 : 0;
    return step.has_lanes() && kernel.counts.calls <= most_calls && kernel.nodes.size() <= small;
}

SystemFunction of_lanes(SystemFunction function, const Step& step) {
    function.takes_lanes = step.has_lanes();
    function.is_inlined = is_inlined(function.kernel, step);
    return function;
}

/// A function of one result for each degree of freedom, of lanes where a step has some.
SystemFunction slope(const System& system, const Step& step, std::string name,
                     const Kernel& kernel) {
    SystemFunction function;
    function.name = std::move(name);
    function.targets = components("out", system.degrees_of_freedom());
    function.kernel = kernel;
    function.out = fmt::format("{}& out", vector_type(step.has_lanes()));
    return of_lanes(std::move(function), step);
}

/// `dHdq`, or another derivative.
std::string first_derivative(const System& system, char variable) {
    return fmt::format("d{}d{}", system.function_letter(), variable);
}

/// dH/dq and dH/dp.
SystemFunction both_gradients(const System& system, const Step& step, const Kernel& kernel) {
    const std::size_t n = system.degrees_of_freedom();
    const std::string by_q = first_derivative(system, 'q');
    const std::string by_p = first_derivative(system, system.conjugate_letter());
    SystemFunction function = slope(system, step, "gradient", kernel);
    function.targets = components(by_q, n);
    for (std::string& target : components(by_p, n)) {
        function.targets.push_back(std::move(target));
    }
    function.out = fmt::format("{0}& {1}, {0}& {2}", vector_type(step.has_lanes()), by_q, by_p);
    function.has_forces = true;
    return of_positions(std::move(function), step);
}

/// What steps evaluate.
std::vector<SystemFunction> slopes(const System& system, const Step& step,
                                   const Evaluations& evaluations) {
    std::vector<SystemFunction> result;
    if (step.slopes == Slopes::joint) {
        result.push_back(both_gradients(system, step, evaluations.gradients.joint));
    } else {
        const GradientKernels& gradients = evaluations.gradients;
        result.push_back(of_positions(slope(system, step, "dHdq", gradients.by_q), step));
        result.back().has_forces = true;
        result.push_back(of_momenta(slope(system, step, "dHdp", gradients.by_conjugates), step));
    }
    if (system.side == Side::lagrangian) {
        result.push_back(
            of_momenta(slope(system, step, "dLdv", evaluations.gradients.by_conjugates), step));
    }
    if (evaluations.inverse_mass) {
        result.push_back(slope(system, step, "inverse_mass", *evaluations.inverse_mass));
        result.back().has_q = false;
    }
    if (evaluations.shared) {
        add_shared(result, *evaluations.shared, evaluations.gradients, system, step);
    }
    if (evaluations.stiffness) {
        SystemFunction function{"stiffness", {}, *evaluations.stiffness, false, false};
        function.targets = components("out", evaluations.stiffness->results.size());
        function.out = fmt::format("std::array<Scalar, {}>& out", function.targets.size());
        result.push_back(std::move(function));
    }
    if (evaluations.constant) { add_constant_terms(result, *evaluations.constant); }
    if (evaluations.second) { add_second_derivatives(result, *evaluations.second, system, step); }
    if (evaluations.tangents) { add_tangents(result, *evaluations.tangents, system); }
    return result;
}

/// The constants of a quadratic H that are not zero.
SystemFunction quadratic(const System& system) {
    const Structure& found = system.structure;
    const Hessian& second = hessian_of(system);
    const std::size_t n = system.degrees_of_freedom();
    SystemFunction function{"quadratic", {}, {}, false, false};
    function.out = fmt::format("hvi::detail::Quadratic<Scalar, {}>& H", n);
    Results results;
    const auto add = [&](std::string target, const Scaled& value) {
        if (value.is_zero()) { return; }
        function.targets.push_back(std::move(target));
        results.push_back(value);
    };
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            add(fmt::format("H.qq[{}][{}]", i, j), second.qq[i][j]);
            add(fmt::format("H.qp[{}][{}]", i, j), second.mixed[i][j]);
            add(fmt::format("H.pp[{}][{}]", i, j), second.conjugates[i][j]);
        }
        add(fmt::format("H.by_q[{}]", i), found.by_q[i]);
        add(fmt::format("H.by_p[{}]", i), found.by_p[i]);
    }
    function.kernel = kernel(system.graph, std::move(results));
    return function;
}

std::vector<SystemFunction> functions(const System& system, const SceneWishes& wishes,
                                      const Step& step, const Evaluations& evaluations) {
    const bool is_map = std::holds_alternative<TabulatedStep>(step.form);
    std::vector<SystemFunction> result =
        is_map ? std::vector<SystemFunction>{quadratic(system)} : slopes(system, step, evaluations);
    for (SystemFunction& function : result) {
        function.is_counted = wishes.evaluations && function.has_forces;
    }
    for (const ClassValue& value : values_of_class(system, wishes)) {
        SystemFunction function;
        function.name = value.name;
        function.kernel = kernel(system.graph, {value.sums->front().value});
        function.has_time = value.has_time;
        result.push_back(std::move(function));
    }
    return result;
}

void mirror(Writer& writer, std::size_t n) {
    writer.open("for (std::size_t i = 1; i < {}; ++i) {{", n);
    writer.line("for (std::size_t j = 0; j < i; ++j) {{ out(j, i) = out(i, j); }}").close();
}

void write(Writer& writer, const System& system, GivenNames& given, const SystemFunction& function,
           std::string_view library) {
    NodeNames locals = variable_names(system);
    for (const auto& [node, name] : function.names) { locals[node] = name; }
    std::vector<std::string> arguments;
    const std::string_view vector = vector_type(function.takes_lanes);
    if (function.has_q) {
        arguments.push_back(
            argument(uses_any(function.kernel, coordinate_nodes(system)),
                     fmt::format("const {}& q", rotations_of(system) == 0 ? vector : "Positions")));
    }
    if (function.has_p) {
        arguments.push_back(
            argument(uses_any(function.kernel, conjugate_nodes(system)),
                     fmt::format("const {}& {}", vector, system.conjugate_letter())));
    }
    if (function.has_time) {
        arguments.push_back(
            argument(uses_any(function.kernel, {*system.time}),
                     function.takes_lanes ? "const hvi::detail::ScalarOf<Values>& t" : "Scalar t"));
    }
    if (!function.out.empty()) {
        arguments.push_back(argument(!function.targets.empty(), function.out));
    }
    if (function.is_matrix) { writer.line("template <class Matrix>"); }
    if (function.takes_lanes) {
        writer.line("template <class Values, class Value = hvi::detail::ScalarOf<Values>>");
    }
    const bool is_value = function.out.empty();
    const std::string_view attribute = is_value              ? "[[nodiscard]] "
                                       : function.is_inlined ? "HVI_INLINE_IN_LANES "
                                                             : "";
    writer.open("{}constexpr {} {}({}) const {{", attribute, is_value ? "Scalar" : "void",
                function.name, fmt::join(arguments, ", "));
    if (function.is_counted) {
        writer.line("evaluations += {};",
                    function.takes_lanes ? "hvi::detail::lane_count<Value>" : "1");
    }
    const NodeNames names = given.given(function.kernel, locals);
    const auto results = write_code(writer, system.graph, function.kernel, names,
                                    function.takes_lanes ? "hvi::math" : library,
                                    function.takes_lanes ? "Value" : "Scalar");
    if (is_value) { writer.line("return {};", results.front()); }
    for (std::size_t k = 0; k < function.targets.size(); ++k) {
        writer.line("{} = {};", function.targets[k], results[k]);
    }
    if (function.is_mirrored) { mirror(writer, system.degrees_of_freedom()); }
    writer.close();
}

void write_constructor(Writer& writer, GivenNames& given, std::string_view library) {
    writer.open("constexpr explicit System({}) {{",
                argument(given.uses_inputs(), "const Parameters& parameters"));
    given.write_setup(writer, library);
    writer.close();
}

void write_begin(Writer& writer, const System& system, GivenNames& given, const Kernel& initial,
                 std::string_view library) {
    const char p = system.conjugate_letter();
    const NodeNames parameters = parameter_names(system);
    const bool uses_parameters =
        std::any_of(initial.given.begin(), initial.given.end(),
                    [&](Node node) { return parameters.count(node) != 0; });
    writer.open("static constexpr void begin({}, {}& q, Vector& {}) {{",
                argument(uses_parameters, "const Parameters& parameters"),
                rotations_of(system) == 0 ? "Vector" : "Positions", p);
    const auto results =
        write_code(writer, system.graph, initial, given.given_inputs(initial), library);
    const std::size_t n = coordinate_nodes(system).size();
    for (std::size_t k = 0; k < results.size(); ++k) {
        writer.line("{}[{}] = {};", k < n ? 'q' : p, k < n ? k : k - n, results[k]);
    }
    writer.close();
}

/// The names of families, one after the other.
std::string names_of(const std::vector<SystemFamily>& families) {
    std::vector<std::string> names;
    for (const SystemFamily& family : families) { names.push_back(family.name); }
    return fmt::format("{}", fmt::join(names, ", "));
}

std::string about(const System& system) {
    if (rotations_of(system) > 0) {
        return fmt::format(
            "H = {}, where q is ({}) and p is ({}); D, the part of dH/dq that "
            "belongs to a rotation R, is the derivative of H(R exp(hat eta)) by eta.",
            to_text(system.expression), names_of(system.coordinates), names_of(system.conjugates));
    }
    return fmt::format("{} = {}, where q is ({}) and {} is ({}).", system.function_letter(),
                       to_text(system.expression), names_of(system.coordinates),
                       system.conjugate_letter(), names_of(system.conjugates));
}

/// Coordinates, then momenta or velocities, where the scene begins.
Kernel initial_values(const System& system) {
    return kernel_of_inputs(system.graph, start_of(system));
}

std::string straight_system_text(const System& system, const SceneWishes& wishes, const Step& step,
                                 const Evaluations& evaluations) {
    const std::vector<SystemFunction> all = functions(system, wishes, step, evaluations);
    GivenNames given(system.graph, parameter_names(system));
    // NOTE: the constructor computes what functions need, and constants of both have names.
    Writer body(2);
    for (const SystemFunction& function : all) {
        if (&function != &all.front()) { body.blank(); }
        write(body, system, given, function, library(wishes));
    }
    Writer constructor(2);
    write_constructor(constructor, given, library(wishes));
    if (!system.initial.empty()) {
        body.blank();
        write_begin(body, system, given, initial_values(system), library(wishes));
    }

    Writer writer(1);
    writer.comment(about(system), "/// ");
    writer.open("struct System {{");
    if (rotations_of(system) == 0) {
        writer.line("using Vector = Numbers;");
    } else {
        writer.line("using Vector = typename Space::Vector;");
        writer.line("using Positions = typename Space::Positions;");
    }
    if (evaluations.tangents) {
        // NOTE: an array of none would do, were it not that compilers warn of it.
        writer.line("using Tangent = std::array<Scalar, {}>;",
                    std::max<std::size_t>(1, evaluations.tangents->kept.size()));
    }
    if (const auto* form = std::get_if<VelocityStep>(&step.form)) {
        writer.line("{}", mass_text(*form));
    }
    writer.blank().insert(constructor.str()).blank().insert(body.str());
    if (wishes.evaluations) {
        writer.blank().line("mutable std::int64_t evaluations = 0;  // of dH/dq");
    }
    Writer data(2);
    given.write_data(data);
    if (!data.str().empty()) { writer.blank().insert(data.str()); }
    return writer.close("};").str();
}

}  // namespace

std::string mass_text(const VelocityStep& form) {
    return fmt::format("static constexpr bool has_diagonal_mass = {};",
                       form.has_diagonal_mass ? "true" : "false");
}

std::string system_text(const System& system, const SceneWishes& wishes, const Step& step,
                        const Evaluations* evaluations) {
    return evaluations != nullptr ? straight_system_text(system, wishes, step, *evaluations)
                                  : loop_system_text(system, wishes, step);
}

}  // namespace hvi::gen
