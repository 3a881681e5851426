// Stage equations in lanes.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/steps/along.hpp"
#include "generator/emit/steps/clock.hpp"
#include "generator/emit/steps/implicit_parts.hpp"
#include "generator/emit/steps/slope_calls.hpp"
#include "generator/emit/steps/starting_values.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {
namespace {

using Kind = StageNode::Kind;

bool has_linear_part(const Step& step) {
    return step.corrections && exists(step.corrections->linear);
}

bool has_constant_hessian(const Step& step) {
    return step.corrections && std::holds_alternative<CoupledConstants>(step.corrections->linear);
}

/// The stage equations of this step.
std::string make_coupled(const Step& step) {
    return fmt::format(
        "Coupled{{{}s_{}{}{}}}", coupled_arguments(step), step.shared_slopes > 0 ? ", shared_" : "",
        step.corrections ? ", corrections_" : "", has_linear_part(step) ? ", linear_" : "");
}

/// The rows of what dH/dp takes from the dH/dq before it.
std::string type_of_shared(const Step& step) {
    return fmt::format("hvi::detail::LaneRows<Scalar, {}, {}>", step.positions.size(),
                       step.shared_slopes);
}

/// The template arguments of lanes of stages: `8`, or `8, 4` in registers of 4.
std::string lane_arguments(const Step& step, std::string_view between = "") {
    const std::string stages = fmt::format("{}{}", step.positions.size(), between);
    return step.register_width == widest_register
               ? stages
               : fmt::format("{}, {}", stages, step.register_width);
}

/// `first`: what is done before the starting values; `arguments`: of what ends the step.
std::string steps_of_lanes(const Step& step, const std::vector<std::string>& first,
                           std::string_view arguments) {
    Writer writer(2);
    for (const std::string& line : first) { writer.line("{}", line); }
    writer.line("predict({});", step.iteration()->takes_parts() ? "part" : "").blank();
    writer.line("status = solver_.solve({});", make_coupled(step));
    writer.line("if (!status.ok()) {{ return status; }}");
    writer.insert(call_of_carry(step));
    writer.blank().line("s_.advance({});", arguments);
    return writer.line("return {};", end_of_step(step, "status.iterations")).str();
}

/// Arguments of what extrapolates a slope.
std::string extrapolation_of(const Iteration& iteration, std::string_view slope) {
    const char* const part = iteration.takes_parts() ? "[part]" : "";
    if (!iteration.extrapolation.front().before) { return fmt::format("N_lanes{}", part); }
    return fmt::format("N_lanes{0}, N_before_lanes{0}, {1}_before_", part, slope);
}

std::string prediction_of_lanes(const Step& step, const Iteration& iteration,
                                const auto& extrapolate) {
    Writer writer(1);
    open_predict(writer, iteration, "slopes");
    if (!iteration.extrapolation.empty()) {
        const Extrapolation& from = iteration.extrapolation.front();
        open_extrapolation(writer, from);
        extrapolate(writer);
        close_extrapolation(writer, from, predicted_slopes(step));
    }
    writer.line("{}.predict();", make_coupled(step));
    return writer.close().str();
}

// ---- corrections ----

/// The type that solves the linear part of the equations of `unknowns`, Position or Pair.
std::string type_of_linear_part(const Step& step, std::string_view unknowns) {
    const auto* stiff = std::get_if<StiffComponents>(&step.corrections->linear);
    if (stiff == nullptr) {
        return fmt::format("hvi::detail::{}Corrections<Vector, hvi::detail::ConstantHessian, {}>",
                           unknowns, lane_arguments(step, ", StageModes"));
    }
    const std::string between = fmt::format(", {}, StageModes", stiff->components.size());
    return fmt::format("hvi::detail::ComponentCorrections<Vector, {}>",
                       lane_arguments(step, between));
}

/// The basis of modes, and the types of what corrects. `matrix`: what C is, as text.
std::string types_of_corrections(const Step& step, std::string_view unknowns,
                                 std::string_view matrix) {
    if (!step.corrections) { return {}; }
    Writer writer(1);
    writer.blank().insert(modes_text(step.corrections->modes, "StageModes", matrix, 1)).blank();
    const std::string lanes = lane_arguments(step, ", StageModes");
    writer.line("using Corrections =");
    writer.line("    hvi::detail::{}Corrections<Vector, hvi::detail::HessianInTheMiddle, {}>;",
                unknowns, lanes);
    if (has_linear_part(step)) {
        writer.line("using LinearPart = hvi::detail::OfStepSize<{}>;",
                    type_of_linear_part(step, unknowns));
    }
    return writer.str();
}

/// Members of the stage equations beside `hessian`, which evaluates second derivatives.
std::string members_for_corrections(const Step& step, const std::string& begin,
                                    const std::string& hessian) {
    if (!step.corrections) { return {}; }
    const SolverCosts& costs = step.corrections->costs;
    Writer writer(2);
    writer.line("Corrections& corrections;");
    if (has_linear_part(step)) { writer.line("LinearPart& linear;"); }
    if (const auto* stiff = std::get_if<StiffComponents>(&step.corrections->linear)) {
        writer.blank().line("static constexpr std::array<std::size_t, {}> stiff{{{}}};",
                            stiff->components.size(), fmt::join(stiff->components, ", "));
    }
    writer.blank();
    writer.line("static constexpr hvi::detail::SolverCosts costs{{{}, {}, {}, {}}};", costs.sweep,
                costs.linear, costs.correction, costs.factors);
    writer.blank().comment("The stages of the starting values.", "/// ");
    writer.line("void begin_corrections() {{ {} }}", begin).insert(hessian);
    return writer.str();
}

/// See hvi::detail::JacobianOfStages.
Writer coefficients_of_stages(const Step& step, std::string_view table) {
    Writer writer(2);
    writer.line("static constexpr std::size_t stages = {};", step.positions.size());
    writer.line("static constexpr Scalar coefficient(std::size_t j, std::size_t i) {{ return "
                "{}[j][i]; }}",
                table);
    return writer;
}

std::string members_of_lanes(const Step& step, std::string_view stages) {
    Writer writer(1);
    writer.line("System system_;").insert(clock_member(step));
    writer.line("hvi::detail::{}<Vector, {}> s_;", stages, lane_arguments(step));
    if (step.shared_slopes > 0) { writer.line("{} shared_{{}};", type_of_shared(step)); }
    if (step.corrections) { writer.line("Corrections corrections_;"); }
    if (has_linear_part(step)) { writer.line("LinearPart linear_;"); }
    writer.line("typename Solver::template Iteration<Vector> solver_;");
    declare_slopes_before(writer, step);
    return writer.str();
}

std::vector<std::string> runtime_of_lanes(const Step& step, std::string_view stages) {
    std::vector<std::string> headers{fmt::format("detail/lanes/{}", stages)};
    if (step.corrections) { headers.emplace_back("detail/solvers/lane_corrections"); }
    return headers;
}

// ---- positions alone ----

/// The time behind another argument.
std::string times_as_argument(const Step& step) {
    const std::string times = times_of_lanes(step);
    return times.empty() ? times : ", " + times;
}

std::string velocity_predict_text(const Step& step, const Iteration& iteration) {
    return prediction_of_lanes(step, iteration, [&](Writer& writer) {
        writer.line("s_.extrapolate({});", extrapolation_of(iteration, "Lp"));
        writer.line("s_.drifts(system_);");
    });
}

/// Where the step begins, in a struct of stage equations.
SlopePoint start_in_struct(const Step& step) {
    return {"s.at.q", "s.at.p", time_of_start(step, "s")};
}

/// The body of predict() of the stage equations.
std::string velocities_from_start(const Step& step) {
    Writer writer(2);
    writer.line("auto&& slope = hvi::detail::scratch(s.slope);");
    writer.line("system.{};", force_call(step, start_in_struct(step), "slope"));
    writer.line("s.predict(system, slope);");
    return writer.str();
}

std::string corrections_of_positions(const Step& step) {
    const SlopePoint at{"s.middle()", "",
                        time_of_stage(step, std::to_string(step.positions.size() / 2), "s")};
    Writer hessian(2);
    hessian.line("template <class Matrix>");
    hessian.line("void hessian_in_the_middle(Matrix& out) const {{ system.{}; }}",
                 hessian_call(at, "out"));
    if (has_constant_hessian(step)) {
        hessian.line("template <class Matrix>");
        hessian.line("void constant_hessian(Matrix& out) const {{ system.constant_d2Hdq2(out); }}");
    }
    return members_for_corrections(step, "positions();", hessian.str());
}

/// Members that Newton's method asks for, of stages that are positions.
std::string newton_of_position_lanes(const Step& step, const VelocityStep& form) {
    if (!form.iteration.takes_newton()) { return {}; }
    if (!step.corrections) {
        return newton_of_positions(step, form, step.blocks.front().of(Kind::Q),
                                   "s.drifts(system);");
    }
    return coefficients_of_stages(step, "n").insert(linearised(step)).str();
}

}  // namespace

ImplicitParts lane_parts(const Step& step, const VelocityStep& form, const SceneWishes& wishes) {
    const Block& block = step.blocks.front();
    Writer constants(1);
    constants.insert(constants_text(step, form, wishes)).blank();
    constants.line("static constexpr hvi::detail::VelocityTable<Scalar, stages> cn_lanes{{c, n}};");
    columns_of_extrapolation(constants, form.iteration);
    constants.insert(types_of_corrections(step, "Position", "b_i n_ij"));
    ImplicitParts parts;
    parts.runtime = runtime_of_lanes(step, "velocity_lanes");
    parts.steps =
        steps_of_lanes(step, {"s_.weigh(system_, b);", "s_.drift_freely(system_, cn_lanes);"},
                       "system_, cn_lanes");
    parts.constants = constants.str();
    parts.predict = velocity_predict_text(step, form.iteration);
    parts.coupled =
        fill_part("velocity_lanes.hpp.in",
                  {{"unknowns", unknowns(block)},
                   {"member", clock_reference(step)},
                   {"type", fmt::format("VelocityLanes<Vector, {}>", lane_arguments(step))},
                   {"times", times_as_argument(step)},
                   {"predict", velocities_from_start(step)},
                   {"corrections", corrections_of_positions(step)},
                   {"newton", newton_of_position_lanes(step, form)}});
    parts.members = members_of_lanes(step, "VelocityLanes");
    if (wishes.curve) {
        const std::size_t count = step.positions.size();
        parts.curve =
            curve_text(step, *wishes.curve, "s_.increment_q(cn_lanes, static_cast<std::size_t>(k))",
                       slopes_in_lanes("W", count), slopes_in_lanes("Lp", count));
    }
    return parts;
}

// ---- positions and momenta ----

namespace {

/// NOTE: for separable H the slopes of p are enough.
std::string pair_predict_text(const Step& step, const Iteration& iteration) {
    return prediction_of_lanes(step, iteration, [&](Writer& writer) {
        if (!step.is_separable()) {
            writer.line("s_.extrapolate_q({});", extrapolation_of(iteration, "Lq"));
        }
        writer.line("s_.extrapolate_p({});", extrapolation_of(iteration, "Lp"));
    });
}

/// The body of predict() of the stage equations.
std::string pairs_from_start(const Step& step) {
    const SlopePoint at = start_in_struct(step);
    Writer writer(2);
    if (step.slopes == Slopes::joint) {
        writer.line("Vector dHdq, dHdp;");
        writer.line("system.{};", gradient_call(at, "dHdq", "dHdp"));
        return writer.line("s.predict_q(dHdp);").line("s.predict_p(dHdq);").str();
    }
    writer.line("auto&& slope = hvi::detail::scratch(s.slope);");
    if (!step.is_separable()) {
        writer.line("system.{};", velocity_call(step, at, "slope"));
        writer.line("s.predict_q(slope);");
    }
    writer.line("system.{};", force_call(step, at, "slope"));
    return writer.line("s.predict_p(slope);").str();
}

/// A member that evaluates all second derivatives; `first`: what goes before those.
void open_hessian(Writer& writer, const Step& step, std::string_view name, std::string_view first) {
    writer.line("template <class Matrix>");
    writer.open("void {}({}Matrix& qq, {}Matrix& qp, Matrix& pp) const {{", name, first,
                step.is_separable() ? "[[maybe_unused]] " : "");
}

void hessians_at(Writer& writer, const Step& step, const SlopePoint& at) {
    writer.line("system.{};", hessian_qq_call(step, at, "qq"));
    if (!step.is_separable()) { writer.line("system.{};", hessian_qp_call(at, "qp")); }
    writer.line("system.{};", hessian_pp_call(step, at, "pp")).close();
}

std::string corrections_of_pairs(const Step& step) {
    Writer hessian(2);
    open_hessian(hessian, step, "hessian_in_the_middle", "");
    hessian.line("const Vector q = s.middle_q(), p = s.middle_p();");
    hessians_at(hessian, step,
                {"q", "p", time_of_stage(step, std::to_string(step.positions.size() / 2), "s")});
    if (has_constant_hessian(step)) {
        open_hessian(hessian, step, "constant_hessian", "");
        hessian.line("system.constant_d2Hdq2(qq);");
        if (!step.is_separable()) { hessian.line("system.constant_d2Hdqdp(qp);"); }
        hessian.line("system.constant_d2Hdp2(pp);").close();
    }
    hessian.line("void all_slopes() {{ {} }}", step.slopes == Slopes::joint ? "slopes();"
                                               : step.shared_slopes > 0
                                                   ? "forces(); velocities_after_forces();"
                                                   : "velocities(); forces();");
    return members_for_corrections(step,
                                   step.is_separable() ? "momenta(); velocities(); positions();"
                                                       : "momenta(); positions();",
                                   hessian.str());
}

/// Members that Newton's method asks for, of stages that are pairs.
std::string newton_of_pair_lanes(const Step& step, const Iteration& iteration) {
    if (!iteration.takes_newton()) { return {}; }
    if (step.corrections) {
        Writer writer = coefficients_of_stages(step, "m");
        open_hessian(writer, step, "hessian", "std::size_t i, ");
        hessians_at(writer, step,
                    {"s.position(i)", "s.momentum(i)", time_of_stage(step, "i", "s")});
        return writer.str();
    }
    const std::vector<std::size_t> unknown = step.blocks.front().of(Kind::Lq);
    Writer writer(2);
    writer.line("static constexpr std::array<std::size_t, {}> unknown_q{{{}}};", unknown.size(),
                fmt::join(unknown, ", "));
    writer.line("static constexpr std::array<std::size_t, {}> unknown_p = unknown_q;",
                unknown.size());
    const auto function = [&](std::string_view name, std::string_view arguments,
                              std::string_view value) {
        writer.line("static constexpr Scalar {}({}) {{ return {}; }}", name, arguments, value);
    };
    function("coefficient_q", "std::size_t i, std::size_t j", "m[i][j]");
    function("coefficient_p", "std::size_t j, std::size_t i",
             fmt::format("{}[j][i]", table_mt(step)));
    function("weight_q", "std::size_t j", "b[j]");
    function("weight_p", "std::size_t i", "b[i]");
    return writer.str();
}

std::string shared_reference(const Step& step) {
    if (step.shared_slopes == 0) { return {}; }
    Writer writer(2);
    writer.line("/// What dH/dp takes from the dH/dq before it.");
    return writer.line("{}& shared;", type_of_shared(step)).str();
}

/// Members of the stage equations that evaluate H.
std::string slopes_of_lanes(const Step& step) {
    const SlopePoint at{"s.all_positions()", "s.all_momenta()", times_of_lanes(step)};
    Writer writer(2);
    if (step.slopes == Slopes::joint) {
        writer.open("[[gnu::always_inline]] void slopes() {{");
        writer.line("auto dHdq = s.forces(), dHdp = s.velocities();");
        return writer.line("system.{};", gradient_call(at, "dHdq", "dHdp")).close().str();
    }
    writer.open("[[gnu::always_inline]] void velocities() {{").line("auto out = s.velocities();");
    writer.line("system.{};", velocity_call(step, at, "out")).close();
    writer.open("[[gnu::always_inline]] void forces() {{").line("auto out = s.forces();");
    if (step.shared_slopes == 0) {
        return writer.line("system.{};", force_call(step, at, "out")).close().str();
    }
    writer.line("auto kept = s.write_to(shared);");
    writer.line("system.{};", force_call(step, at, "out, kept")).close().blank();
    writer.comment("At the positions where forces() was.", "/// ");
    writer.open("[[gnu::always_inline]] void velocities_after_forces() {{");
    writer.line("auto out = s.velocities();");
    return writer.line("system.{};", velocity_call(step, at, "s.read_from(shared), out"))
        .close()
        .str();
}

}  // namespace

ImplicitParts lane_parts(const Step& step, const PairStep& form, const SceneWishes& wishes) {
    HVI_CHECK(form.iteration.has_value());
    const Iteration& iteration = *form.iteration;
    const Block& block = step.blocks.front();
    Writer constants(1);
    constants.insert(constants_text(step, form, wishes)).blank();
    columns(constants, "m");
    if (step.partner != Partner::same) { columns(constants, "mt"); }
    columns_of_extrapolation(constants, iteration);
    constants.insert(types_of_corrections(step, "Pair", "b_i m_ij"));
    ImplicitParts parts;
    parts.runtime = runtime_of_lanes(step, "stage_lanes");
    parts.steps = steps_of_lanes(step, {"s_.weigh(b);"}, "");
    parts.constants = constants.str();
    parts.predict = pair_predict_text(step, iteration);
    parts.coupled = fill_part(
        "pair_lanes.hpp.in", {{"unknowns", unknowns(block)},
                              {"member", clock_reference(step)},
                              {"type", fmt::format("StageLanes<Vector, {}>", lane_arguments(step))},
                              {"shared", shared_reference(step)},
                              {"predict", pairs_from_start(step)},
                              {"corrections", corrections_of_pairs(step)},
                              {"newton", newton_of_pair_lanes(step, iteration)},
                              {"separable", std::string(truth(step.is_separable()))},
                              {"mt", std::string(table_mt(step))},
                              {"slopes", slopes_of_lanes(step)}});
    parts.members = members_of_lanes(step, "StageLanes");
    if (wishes.curve) {
        parts.curve = curve_text(step, *wishes.curve, "s_.increment_q(static_cast<std::size_t>(k))",
                                 slopes_in_lanes("Lq", step.momenta.size()),
                                 slopes_in_lanes("Lp", step.positions.size()));
    }
    return parts;
}

}  // namespace hvi::gen
