// Headers of steps in natural charts of rotations.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/steps/clock.hpp"
#include "generator/emit/steps/implicit_parts.hpp"
#include "generator/emit/steps/starting_values.hpp"
#include "generator/emit/steps/system_part.hpp"
#include "src/hvi/version.hpp"

namespace hvi::gen {

namespace {

/// Returns the type of the stage equations. NOTE: with a clock the equations hold a reference to
/// it.
std::string equations_type(const Step& step) {
    return fmt::format("hvi::detail::{}<System, Stages{}>",
                       step.has_lanes() ? "CoupledChartLanes" : "CoupledCharts",
                       step.depends_on_time()
                           ? fmt::format(", hvi::detail::Clock<Scalar, {}>", step.positions.size())
                           : "");
}

/// Texts of a step for access to the numbers of a state.
struct StateTexts {
    std::string_view begin;  ///< before the step
    std::string_view state;  ///< name of the numbers in a row
    std::string_view end;    ///< after the step
};
constexpr StateTexts in_members{numbers_of_bodies::taken, numbers_of_bodies::name,
                                "if (status.ok()) { set(x, at); }"};
constexpr StateTexts in_a_row{"if (!system_.fits(x.q, x.p)) {\n"
                              "    return Status(Status::Code::dimension_mismatch);\n"
                              "}",
                              "x", ""};

std::string step_text(const Step& step) {
    const StateTexts& texts = step.container == Container::vectors ? in_a_row : in_members;
    return fill_part(
        "chart_step.hpp.in",
        {{"clock", clock_begins(step, "s_.forget()")},
         {"begin", std::string(texts.begin)},
         {"state", std::string(texts.state)},
         {"set", std::string(texts.end)},
         {"equations", fmt::format("m, {}{}{}", table_mt(step), step.has_lanes() ? ", lanes" : "",
                                   step.depends_on_time() ? ", clock_" : "")},
         {"end", clock_ends(step, "status")}});
}

std::string constants_text(const Step& step, const ChartStep& form, const SceneWishes& wishes) {
    Writer writer(1);
    writer.insert(coefficients_text(step, form.coefficients));
    if (const std::string times = times_text(step); !times.empty()) {
        writer.blank().insert(times);
    }
    writer.insert(extrapolation_text(form.iteration));
    if (step.has_lanes()) {
        writer.blank().line("static constexpr hvi::detail::ChartTable<Scalar, {}> lanes{{m, {}}};",
                            step.positions.size(), table_mt(step));
        columns_of_extrapolation(writer, form.iteration);
    }
    if (wishes.curve) { writer.insert(curve_table(step, *wishes.curve, library(wishes))); }
    return with_rounding(writer.str());
}

std::string prediction(const Step& step, const Iteration& iteration) {
    Writer writer(1);
    open_predict(writer, iteration, "slopes");
    const std::string_view m = step.has_lanes() ? "lanes" : "m";
    if (!iteration.extrapolation.empty()) {
        const bool takes_two = iteration.extrapolation.front().before.has_value();
        const std::string_view of = step.has_lanes() ? "_lanes" : "";
        writer.line("if (s_.extrapolate({0}, N{1}{2})) {{ return; }}", m, of,
                    takes_two ? fmt::format(", N_before{}", of) : "");
    }
    writer.open("s_.predict({}, [this](const auto& q, const auto& p, auto& dHdq, auto& dHdp) {{",
                m);
    writer.line("system_.gradient(q, p, {}dHdq, dHdp);",
                step.depends_on_time() ? "clock_.start, " : "");
    return writer.close("});").close().str();
}

std::string members_text(const Step& step) {
    Writer writer(1);
    writer.line("System system_;").insert(clock_member(step));
    writer.line("Stages s_;");
    writer.line("typename Solver::template Iteration<Vector> solver_;");
    return writer.str();
}

std::string coupled_text(const Step& step) {
    Writer writer(1);
    writer.line("using Stages = hvi::detail::{}<Space, {}>;",
                step.has_lanes() ? "ChartLanes" : "ChartStages", step.positions.size());
    writer.line("using Coupled = {};", equations_type(step));
    return writer.str();
}

/// Returns the member position(tau): coordinates and rotations on the curve of the step.
std::string curve_member(const Step& step, const Curve& curve) {
    const bool is_straight = curve.F.front().empty();
    Writer writer(1);
    writer.comment(
        fmt::format(
            "Where the bodies are at tau h within the last step, on the curve of the "
            "method (Sections 4.1 and 5.4 of the paper): of a rotation R_0 exp(hat xi(tau)). "
            "From the exact solution through its beginning it is O(h^{}) away for all tau "
            "in [0, 1]. After a step that failed, after reset() and before any step there "
            "are no numbers.",
            curve.order + 1),
        "/// ");
    const bool is_any_size = step.container == Container::vectors;
    writer.open("[[nodiscard]] {} position(Scalar tau) const {{",
                is_any_size ? "Vector" : "Placement");
    if (is_any_size) {
        writer.open("if (!s_.has_ended()) {{")
            .line("return hvi::detail::nowhere(Vector(system_.size_));")
            .close();
    } else {
        writer.line("Placement x;");
    }
    if (!is_straight) {
        writer.line("const auto bend = hvi::detail::departures(curve, {});",
                    curve.A.empty() ? "tau" : "tau, curve_terms(tau), curve_terms(1)");
    }
    const std::string_view place = is_straight ? "s_.position(tau)" : "s_.position(tau, bend)";
    if (is_any_size) { return writer.line("return {};", place).close().str(); }
    return writer.line("set(x, {});", place).line("return x;").close().str();
}

}  // namespace

std::string emit_one(const OneStepMethod& method, const Step& step, const ChartStep& form,
                     const EmitOptions& options) {
    const SystemPart system = system_part(method, step, options);
    std::vector<std::string> runtime{step.has_lanes() ? "detail/groups/coupled_chart_lanes"
                                                      : "detail/groups/coupled_charts"};
    for (const std::string& header : clock_runtime(step)) { runtime.push_back(header); }
    if (step.container == Container::vectors) { runtime.emplace_back("detail/groups/body_space"); }
    if (options.wishes.curve) { runtime.emplace_back("detail/stages/curve"); }
    if (options.wishes.float128) { runtime.emplace_back("detail/numbers/math"); }
    for (const std::string& header : solver_headers(step, options.seldom)) {
        runtime.push_back(header);
    }
    Holes holes = holes_of(system);
    holes.merge(Holes{
        {"format", std::to_string(hvi::runtime_format)},
        {"runtime", runtime_includes(std::move(runtime))},
        {"parameter", ""},
        {"state", system.state},
        {"curve", options.wishes.curve ? curve_member(step, *options.wishes.curve) : std::string()},
        {"step", step_text(step)},
        {"part", ""},
        {"action", ""},
        {"integral", ""},
        {"forget", "s_.forget();"},
        {"constants", constants_text(step, form, options.wishes)},
        {"predict", prediction(step, form.iteration)},
        {"coupled", coupled_text(step)},
        {"members", members_text(step)}});
    return fill("implicit.hpp.in", holes);
}

}  // namespace hvi::gen
