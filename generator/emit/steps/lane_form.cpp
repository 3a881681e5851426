// Stage equations in lanes.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/steps/clock.hpp"
#include "generator/emit/steps/implicit_parts.hpp"
#include "generator/emit/steps/slope_calls.hpp"
#include "generator/emit/steps/starting_values.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {
namespace {

using Kind = StageNode::Kind;

/// `first`: what is done before the starting values.
std::string steps_of_lanes(const Step& step, const std::vector<std::string>& first,
                           std::string_view table) {
    Writer writer(2);
    writer.line("s_.weigh(b);");
    for (const std::string& line : first) { writer.line("{}", line); }
    writer.line("predict();").blank();
    writer.line("status = solver_.solve(Coupled{{{}s_}});", coupled_arguments(step));
    writer.line("if (!status.ok()) {{ return status; }}").blank();
    writer.line("s_.advance({});", table);
    return writer.line("return {};", end_of_step(step, "status.iterations")).str();
}

/// `name`_lanes of a table.
void columns(Writer& writer, std::string_view name) {
    writer.line("static constexpr auto {0}_lanes = hvi::detail::lane_columns({0});", name);
}

void columns_of_extrapolation(Writer& writer, const Iteration& iteration) {
    if (!iteration.extrapolation) { return; }
    columns(writer, "N");
    if (iteration.extrapolation->before) { columns(writer, "N_before"); }
}

/// Arguments of what extrapolates a slope.
std::string extrapolation_of(const Extrapolation& from, std::string_view slope) {
    return from.before ? fmt::format("N_lanes, N_before_lanes, {}_before_", slope) : "N_lanes";
}

std::string prediction_of_lanes(const Step& step, const Iteration& iteration,
                                const auto& extrapolate, const auto& constant) {
    Writer writer(1);
    open_predict(writer, iteration, "slopes");
    if (iteration.extrapolation) {
        open_extrapolation(writer, *iteration.extrapolation);
        extrapolate(writer, *iteration.extrapolation);
        close_extrapolation(writer, *iteration.extrapolation, predicted_slopes(step));
    }
    constant(writer);
    return writer.close().str();
}

std::string members_of_lanes(const Step& step, std::string_view stages) {
    Writer writer(1);
    writer.line("System system_;").insert(clock_member(step));
    writer.line("hvi::detail::{}<Vector, {}> s_;", stages, step.positions.size());
    writer.line("typename Solver::template Iteration<Vector> solver_;");
    declare_slopes_before(writer, step);
    return writer.str();
}

// ---- positions alone ----

/// The time behind another argument.
std::string times_as_argument(const Step& step) {
    const std::string times = times_of_lanes(step);
    return times.empty() ? times : ", " + times;
}

std::string velocity_predict_text(const Step& step, const Iteration& iteration) {
    return prediction_of_lanes(
        step, iteration,
        [&](Writer& writer, const Extrapolation& from) {
            writer.line("s_.extrapolate({});", extrapolation_of(from, "W"));
        },
        [&](Writer& writer) {
            writer.line("auto&& slope = hvi::detail::scratch(s_.slope);");
            writer.line("system_.{};", force_call(step, start_of_step(step), "slope"));
            writer.line("s_.predict(system_, slope);");
        });
}

}  // namespace

ImplicitParts lane_parts(const Step& step, const VelocityStep& form, const SceneWishes& wishes) {
    const Block& block = step.blocks.front();
    Writer constants(1);
    constants.insert(constants_text(step, form, wishes)).blank();
    constants.line("static constexpr hvi::detail::VelocityTable<Scalar, stages> cn_lanes{{c, n}};");
    columns_of_extrapolation(constants, form.iteration);
    ImplicitParts parts;
    parts.runtime = {"detail/lanes/velocity_lanes"};
    parts.steps = steps_of_lanes(
        step, {"system_.dHdp(s_.at.p, s_.free_path);", "s_.drift_freely(cn_lanes);"}, "cn_lanes");
    parts.constants = constants.str();
    parts.predict = velocity_predict_text(step, form.iteration);
    parts.coupled = fill_part(
        "velocity_lanes.hpp.in",
        {{"unknowns", unknowns(block)},
         {"member", clock_reference(step)},
         {"times", times_as_argument(step)},
         {"newton", form.iteration.takes_newton()
                        ? newton_of_positions(step, form, block.of(Kind::Q), "s.drifts(system);")
                        : ""}});
    parts.members = members_of_lanes(step, "VelocityLanes");
    if (wishes.curve) {
        parts.curve =
            curve_text(*wishes.curve, step.positions.size(),
                       "s_.increment_q(cn_lanes, static_cast<std::size_t>(k))", [](std::size_t i) {
                           return fmt::format("s_.W[static_cast<std::size_t>(k)][{}]", i);
                       });
    }
    return parts;
}

// ---- positions and momenta ----

namespace {

/// NOTE: for separable H the slopes of p are enough.
std::string pair_predict_text(const Step& step, const Iteration& iteration) {
    return prediction_of_lanes(
        step, iteration,
        [&](Writer& writer, const Extrapolation& from) {
            if (!step.is_separable()) {
                writer.line("s_.extrapolate_q({});", extrapolation_of(from, "Lq"));
            }
            writer.line("s_.extrapolate_p({});", extrapolation_of(from, "Lp"));
        },
        [&](Writer& writer) {
            const SlopePoint at = start_of_step(step);
            if (step.slopes == Slopes::joint) {
                writer.line("Vector dHdq, dHdp;");
                writer.line("system_.{};", gradient_call(at, "dHdq", "dHdp"));
                writer.line("s_.predict_q(dHdp);").line("s_.predict_p(dHdq);");
                return;
            }
            writer.line("auto&& slope = hvi::detail::scratch(s_.slope);");
            if (!step.is_separable()) {
                writer.line("system_.{};", velocity_call(step, at, "slope"));
                writer.line("s_.predict_q(slope);");
            }
            writer.line("system_.{};", force_call(step, at, "slope"));
            writer.line("s_.predict_p(slope);");
        });
}

/// Members of the stage equations that evaluate H.
std::string slopes_of_lanes(const Step& step) {
    const SlopePoint at{"hvi::detail::load(s.Q)", "hvi::detail::load(s.P)", times_of_lanes(step)};
    Writer writer(2);
    if (step.slopes == Slopes::joint) {
        writer.open("void slopes() {{").open("s.slopes([&](auto& dHdq, auto& dHdp) {{");
        writer.line("system.{};", gradient_call(at, "dHdq", "dHdp"));
        return writer.close("});").close().str();
    }
    writer.open("void velocities() {{");
    writer.line("s.velocities([&](auto& out) {{ system.{}; }});", velocity_call(step, at, "out"));
    writer.close().open("void forces() {{");
    writer.line("s.forces([&](auto& out) {{ system.{}; }});", force_call(step, at, "out"));
    return writer.close().str();
}

}  // namespace

ImplicitParts lane_parts(const Step& step, const PairStep& form, const SceneWishes& wishes) {
    HVI_CHECK(form.iteration.has_value());
    const Iteration& iteration = *form.iteration;
    const Block& block = step.blocks.front();
    const std::string stages = std::to_string(step.positions.size());
    Writer constants(1);
    constants.insert(constants_text(step, form, wishes)).blank();
    columns(constants, "m");
    if (step.partner != Partner::same) { columns(constants, "mt"); }
    columns_of_extrapolation(constants, iteration);
    ImplicitParts parts;
    parts.runtime = {"detail/lanes/stage_lanes"};
    parts.steps = steps_of_lanes(step, {}, "");
    parts.constants = constants.str();
    parts.predict = pair_predict_text(step, iteration);
    parts.coupled = fill_part("pair_lanes.hpp.in",
                              {{"unknowns", unknowns(block)},
                               {"member", clock_reference(step)},
                               {"stages", stages},
                               {"indices", fmt::format("{}", fmt::join(block.of(Kind::Lq), ", "))},
                               {"separable", std::string(truth(step.is_separable()))},
                               {"mt", std::string(table_mt(step))},
                               {"slopes", slopes_of_lanes(step)}});
    parts.members = members_of_lanes(step, "StageLanes");
    if (wishes.curve) {
        parts.curve = curve_text(
            *wishes.curve, step.momenta.size(), "s_.increment_q(static_cast<std::size_t>(k))",
            [](std::size_t i) { return fmt::format("s_.Lq[static_cast<std::size_t>(k)][{}]", i); });
    }
    return parts;
}

}  // namespace hvi::gen
