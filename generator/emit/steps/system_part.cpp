// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/steps/system_part.hpp"

#include <algorithm>

#include "generator/emit/steps/along.hpp"
#include "generator/emit/steps/clock.hpp"
#include "generator/emit/steps/header.hpp"
#include "generator/emit/system/rotation_code.hpp"
#include "generator/emit/text/names.hpp"

namespace hvi::gen {

namespace {

/// `constexpr` for steps without a solver, which the compiler may compute.
std::string_view constant_if_explicit(const Step& step) {
    const bool has_flows = std::holds_alternative<FlowStep>(step.form);
    return step.is_explicit() && !has_flows ? "constexpr " : "";
}

// ---- a class of the user ----

std::string purpose_for_users(const Step& step) {
    Writer writer(0);
    writer.comment(
        fmt::format("{}`System` names its `Vector`, std::array<double, n> or one of Eigen, also of "
                    "float, long double or __float128, and has const members {}.",
                    step.is_separable() ? "For H(q, p) = T(p) + U(q). " : "",
                    step.is_separable() ? "dHdq(q, out) = grad U and dHdp(p, out) = grad T"
                                        : "dHdq(q, p, out) and dHdp(q, p, out)"),
        "/// ");
    if (!step.is_explicit()) {
        writer.comment("`Solver` is hvi::FixedPoint, or hvi::Newton of <hvi/newton.hpp> for steps "
                       "that are not small against the fastest period.",
                       "/// ");
    }
    return writer.str();
}

std::string constructor_for_users(const Step& step, std::string_view class_name) {
    Writer writer(1);
    const std::string_view constant = constant_if_explicit(step);
    if (!step.from_parameter) {
        writer.line("{}explicit {}(System system = System{{}})", constant, class_name);
        writer.line("    : system_(std::move(system)) {{}}");
        return writer.str();
    }
    writer.comment(fmt::format("`parameter`: {}, for w = omega h of a basis that is fitted to the "
                               "frequency omega and steps of size h. See status().",
                               step.from_parameter->numbers.parameter),
                   "/// ");
    writer.line("{}(System system, Scalar parameter)", class_name);
    writer.line("    : system_(std::move(system)), coefficients_(parameter) {{}}");
    return writer.str();
}

SystemPart for_users(const Step& step, const EmitOptions& options) {
    SystemPart part;
    part.include = step.is_explicit() ? "" : "#include <array>";
    part.purpose = purpose_for_users(step);
    part.head = step.is_explicit() ? "template <class System>"
                                   : "template <class System, class Solver = hvi::FixedPoint>";
    part.class_name = options.class_name;
    part.condition = fmt::format("static_assert(hvi::detail::check_system<System, {}>());",
                                 step.is_separable() ? "true" : "false");
    part.types = Writer(1)
                     .line("using Vector = typename System::Vector;")
                     .line("using Scalar = hvi::detail::ScalarOf<Vector>;")
                     .str();
    part.state = "hvi::State<Vector>";
    part.construct = constructor_for_users(step, options.class_name);
    return part;
}

// ---- a scene ----

std::string_view numbers(const SceneWishes& wishes) {
    return wishes.float128 ? "float, double, long double, or hvi::math::Widest, which is "
                             "__float128 where libm has functions of it, else long double"
                           : "float, double or long double";
}

/// The scene, its method and its numbers.
std::string purpose_for_scene(const Provenance& provenance, const Step& step,
                              const EmitOptions& options) {
    const System& scene = *options.system;
    const StateVectors vectors = vectors_of(scene);
    const bool is_any_size = vectors == StateVectors::any_size;
    const bool are_threads = step.layout == Layout::threads;
    std::string method = provenance.name;
    if (method.empty()) {
        method = is_any_size ? "a method of its own" : "a method of its own basis and nodes";
    }
    const std::string what = scene.name.empty() ? "This Hamiltonian" : "The scene " + scene.name;
    std::string_view states;
    if (is_any_size) { states = " States hold std::vector."; }
    if (vectors == StateVectors::numbers && !are_threads) {
        states = " States hold Numbers: arrays, or vectors of Eigen of fixed size.";
    }
    Writer writer(0);
    writer.comment(fmt::format("{}{} with {}, computed in Number: {}.{}", what,
                               is_any_size ? " of any size" : "", method,
                               are_threads ? "float or double" : numbers(options.wishes), states),
                   "/// ");
    if (!scene.description.empty()) { writer.comment(scene.description, "/// "); }
    return writer.str();
}

std::string automatic(const Step& step, SeldomSolvers seldom) {
    const std::string newton = newton_policy(step).type;
    const std::string_view policy = step.corrections ? "AutomaticOfLanes" : "Automatic";
    switch (seldom) {
    case SeldomSolvers::within: break;
    case SeldomSolvers::apart:
        return fmt::format("hvi::{}<hvi::detail::Apart<{}>>", policy, newton);
    case SeldomSolvers::alone: return fmt::format("hvi::detail::Alone<{}>", newton);
    }
    return fmt::format("hvi::{}<{}>", policy, newton);
}

std::string solver_type(const Step& step, SeldomSolvers seldom) {
    const Iteration& iteration = *step.iteration();
    switch (iteration.solver) {
    case Solver::of_user: break;
    case Solver::fixed_point: return "hvi::FixedPoint";
    case Solver::newton: return newton_policy(step).type;
    case Solver::newton_taylor: return "hvi::NewtonTaylor";
    case Solver::automatic: return automatic(step, seldom);
    case Solver::sweeps: return fmt::format("hvi::FixedSweeps<{}>", iteration.sweeps);
    }
    HVI_CHECK(false);
    return {};
}

/// Vectors, and what else there is by their container.
std::string vector_types(const Step& step, const System& system) {
    Writer writer(1);
    const StateVectors vectors = vectors_of(system);
    if (vectors == StateVectors::bodies) {
        writer.line("using Space = hvi::detail::ChartSpace<Number, {}, {}>;",
                    flat_coordinates(system), rotations_of(system));
    }
    if (step.layout != Layout::threads) { writer.line("using Vector = {};", vector_type(system)); }
    if (vectors == StateVectors::bodies) { writer.blank().insert(bodies_text(system)); }
    if (vectors == StateVectors::any_size) {
        writer.line("using Place = std::ptrdiff_t;");
        if (rotations_of(system) > 0) {
            writer.line("using Space = hvi::detail::BodySpace<Number>;");
        }
    }
    return writer.str();
}

/// Parameters that another class of the header has declared.
std::string parameters_from(std::string_view class_name) {
    return Writer(1)
        .line("using Parameters = typename Basic{}<Number>::Parameters;", class_name)
        .str();
}

/// The public types up to the scene's System, and the solver.
std::string types_for_scene(const Step& step, const EmitOptions& options) {
    const System& system = *options.system;
    Writer writer(1);
    writer.line("using Scalar = Number;").insert(vector_types(step, system));
    writer.blank().insert(options.parameters_of.empty() ? parameters_text(system, step)
                                                        : parameters_from(options.parameters_of));
    writer.blank().insert(system_text(system, options.wishes, step, options.evaluations));
    if (step.iteration() != nullptr && !step.takes_several()) {
        writer.blank().line("using Solver = {};", solver_type(step, options.seldom));
    }
    writer.insert(type_of_along(step, options.evaluations));
    return writer.blank().str();
}

/// Whether the free parameter of the method is one of the scene.
bool shares_parameter(const Step& step, const System& system) {
    const std::string& name = step.from_parameter->numbers.parameter;
    return std::any_of(system.parameters.begin(), system.parameters.end(),
                       [&](const SystemParameter& parameter) { return parameter.name == name; });
}

/// Returns the constructors where eight trajectories go side by side, each with its own parameters.
std::string constructors_of_trajectories(const Step& step, std::string_view class_name) {
    const std::string_view constant = constant_if_explicit(step);
    const bool has_flows = std::holds_alternative<FlowStep>(step.form);
    Writer writer(1);
    writer.line("{0}{1}() : {1}(Parameters{{}}) {{}}", constant, class_name);
    writer
        .open("{}explicit {}(const Parameters& parameters) : one_(parameters) {{", constant,
              class_name)
        .open("for (std::size_t lane = 0; lane < hvi::trajectories_at_once; ++lane) {{")
        .line("system_.set(lane, one_);");
    if (has_flows) { writer.line("parameters_[lane] = parameters;"); }
    writer.close().close().blank();
    writer.line(
        "/// Gives the trajectory in a lane other parameters. Members that take one trajectory");
    writer.line("/// keep those of the constructor.");
    writer.open("void set_parameters(std::size_t lane, const Parameters& parameters) {{")
        .line("system_.set(lane, System(parameters));");
    if (has_flows) { writer.line("parameters_[lane] = parameters;").line("changed_.add(lane);"); }
    writer.line("reset(lane);").close();
    return writer.str();
}

/// NOTE: two constructors, since a default argument would need Parameters to be complete.
std::string constructors_for_scene(const Step& step, const EmitOptions& options,
                                   std::string_view class_name) {
    Writer writer(1);
    const bool is_any_size = step.container == Container::vectors;
    const std::string_view constant = is_any_size ? "" : constant_if_explicit(step);
    const std::string_view threads = is_any_size ? ", unsigned threads = 1" : "";
    const std::string_view system = is_any_size ? "parameters, threads" : "parameters";
    const auto about_threads = [&] {
        if (is_any_size) { writer.line("/// `threads`: 0 for as many as there are processors."); }
    };
    if (step.layout == Layout::trajectories) {
        writer.insert(constructors_of_trajectories(step, class_name));
    } else if (!step.from_parameter) {
        writer.line("{0}{1}() : {1}(Parameters{{}}) {{}}", constant, class_name);
        about_threads();
        const bool has_flows = std::holds_alternative<FlowStep>(step.form);
        writer.line("{}explicit {}(const Parameters& parameters{}) : system_({}){} {{}}", constant,
                    class_name, threads, system, has_flows ? ", parameters_(parameters)" : "");
    } else {
        const bool is_of_scene = shares_parameter(step, *options.system);
        const std::string parameter =
            is_of_scene ? "parameters." + member_name(step.from_parameter->numbers.parameter)
                        : "parameter";
        writer.comment(fmt::format("`{}`: for w = omega h of a basis that is fitted to the "
                                   "frequency omega and steps of size h. See status().",
                                   parameter),
                       "/// ");
        about_threads();
        writer.line("{}(const Parameters& parameters{}{})", class_name,
                    is_of_scene ? "" : ", Scalar parameter", threads);
        writer.line("    : system_({}), coefficients_({}) {{}}", system, parameter);
    }
    writer.blank().insert(scene_members_text(*options.system, options.wishes, step));
    const bool carries = !options.parameters_of.empty() || step.carries == Carries::directions;
    if (carries && step.iteration() != nullptr) {
        writer.line("/// See hvi::detail::go_on_from().");
        writer.line("void go_on_from(const State& x) {{ s_.go_on_from(x); }}");
    }
    return writer.str();
}

std::string condition_on_numbers(const SceneWishes& wishes) {
    Writer writer(1);
    writer.line("static_assert(hvi::{}<Number>,",
                wishes.float128 ? "math::computes_in" : "detail::is_standard");
    writer.line("              \"hvi: a scene is computed in float, double{}\");",
                wishes.float128 ? ", long double or hvi::math::Widest" : " or long double");
    return writer.str();
}

std::string conditions_for_scene(const System& system, const Step& step,
                                 const SceneWishes& wishes) {
    if (step.layout == Layout::threads) {
        return Writer(1)
            .line("static_assert(hvi::device::computes_in<Number>,")
            .line("              \"hvi: a GPU computes in float or double\");")
            .str();
    }
    if (vectors_of(system) != StateVectors::numbers) { return condition_on_numbers(wishes); }
    Writer writer(1);
    writer.insert(condition_on_numbers(wishes));
    writer.line("static_assert(hvi::detail::is_fixed_vector<Numbers, Number, {}>(),",
                system.degrees_of_freedom());
    writer.line(
        "              \"hvi: vectors are of these numbers, and of fixed size: std::array, or "
        "Eigen's\");");
    return writer.str();
}

SystemPart for_scene(const Provenance& provenance, const Step& step, const EmitOptions& options) {
    const System& system = *options.system;
    SystemPart part;
    part.include = own_includes(system.own_headers) +
                   includes_of_class(system, options.wishes, step, options.evaluations);
    part.purpose = purpose_for_scene(provenance, step, options);
    part.class_name = "Basic" + options.class_name;
    part.head = "template <class Number>";
    if (vectors_of(system) == StateVectors::numbers && step.layout != Layout::threads) {
        part.head = fmt::format("template <class Number, class Numbers = std::array<Number, {}>>",
                                system.degrees_of_freedom());
    }
    part.condition = conditions_for_scene(system, step, options.wishes);
    part.types = types_for_scene(step, options);
    part.state = vectors_of(system) == StateVectors::bodies ? "Bodies" : state_type(step);
    if (step.layout != Layout::threads) {
        part.construct = constructors_for_scene(step, options, part.class_name);
    }
    part.alias = fmt::format("using {} = {}<double>;", options.class_name, part.class_name);
    return part;
}

}  // namespace

std::string own_includes(const std::vector<std::string>& headers) {
    std::string lines;
    for (const std::string& header : headers) { lines += fmt::format("#include \"{}\"\n", header); }
    return lines.empty() ? lines : lines + "\n";
}

SystemPart system_part(const OneStepMethod& method, const Step& step, const EmitOptions& options) {
    switch (step.container) {
    case Container::of_user: return for_users(step, options);
    case Container::arrays:
    case Container::vectors: return for_scene(method.provenance(), step, options);
    }
    HVI_CHECK(false);
    return {};
}

Holes holes_of(const SystemPart& part) {
    return {{"include", part.include},     {"purpose", part.purpose},     {"head", part.head},
            {"name", part.class_name},     {"condition", part.condition}, {"types", part.types},
            {"construct", part.construct}, {"alias", part.alias}};
}

}  // namespace hvi::gen
