// Stage equations in lanes.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/steps/implicit_parts.hpp"
#include "generator/emit/steps/starting_values.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {
namespace {

using Kind = StageNode::Kind;

/// Besides the system and the stages.
std::string member(const Scheme& scheme) {
    return scheme.depends_on_time ? fmt::format("const {}& clock;", clock_type(scheme)) : "";
}

/// The time as the last argument but one of a function of lanes.
std::string times(const Scheme& scheme) {
    return scheme.depends_on_time ? ", hvi::detail::lane_row(clock.t)" : "";
}

/// `first`: what is done before the starting values.
std::string steps_of_lanes(const Scheme& scheme, const std::vector<std::string>& first,
                           std::string_view table) {
    Writer writer(2);
    writer.line("s_.weigh(b);");
    for (const std::string& line : first) { writer.line("{}", line); }
    writer.line("predict();").blank();
    writer.line("status = solver_.solve(Coupled{{{}s_}});", coupled_arguments(scheme));
    writer.line("if (!status.ok()) {{ return status; }}").blank();
    writer.line("s_.advance({});", table);
    return writer.line("return {};", end_of_step(scheme, "status.iterations")).str();
}

/// `name`_lanes of a table.
void columns(Writer& writer, std::string_view name) {
    writer.line("static constexpr auto {0}_lanes = hvi::detail::lane_columns({0});", name);
}

void columns_of_extrapolation(Writer& writer, const Scheme& scheme) {
    if (scheme.extrapolation) { columns(writer, "N"); }
    if (scheme.extrapolation_before) { columns(writer, "N_before"); }
}

/// Arguments of what extrapolates a slope.
std::string extrapolation_of(const Scheme& scheme, std::string_view slope) {
    return scheme.extrapolation_before ? fmt::format("N_lanes, N_before_lanes, {}_before_", slope)
                                       : "N_lanes";
}

std::string prediction_of_lanes(const Scheme& scheme, const auto& extrapolate,
                                const auto& constant) {
    Writer writer(1);
    open_predict(writer, scheme, "slopes");
    if (scheme.extrapolation) {
        open_extrapolation(writer, scheme);
        extrapolate(writer);
        close_extrapolation(writer, scheme);
    }
    constant(writer);
    return writer.close().str();
}

std::string members_of_lanes(const Scheme& scheme, std::string_view stages) {
    Writer writer(1);
    writer.line("System system_;");
    if (scheme.depends_on_time) { writer.line("{} clock_;", clock_type(scheme)); }
    writer.line("hvi::detail::{}<Vector, {}> s_;", stages, scheme.positions.size());
    writer.line("typename Solver::template Iteration<Vector> solver_;");
    declare_slopes_before(writer, scheme);
    return writer.str();
}

// ---- positions alone ----

std::string velocity_predict_text(const Scheme& scheme) {
    return prediction_of_lanes(
        scheme,
        [&](Writer& writer) { writer.line("s_.extrapolate({});", extrapolation_of(scheme, "W")); },
        [&](Writer& writer) {
            writer.line("auto&& slope = hvi::detail::scratch(s_.slope);");
            writer.line("system_.dHdq(s_.at.q, {}slope);", start_time(scheme));
            writer.line("s_.predict(system_, slope);");
        });
}

ImplicitParts velocity_lane_parts(const Scheme& scheme, const SceneWishes& wishes) {
    const Block& block = scheme.blocks.front();
    Writer constants(1);
    constants.insert(velocity_constants(scheme, wishes)).blank();
    constants.line("static constexpr hvi::detail::VelocityTable<Scalar, stages> cn_lanes{{c, n}};");
    columns_of_extrapolation(constants, scheme);
    ImplicitParts parts;
    parts.runtime = {"detail/lanes/velocity_lanes"};
    parts.steps = steps_of_lanes(
        scheme, {"system_.dHdp(s_.at.p, s_.velocity);", "s_.drift_freely(cn_lanes);"}, "cn_lanes");
    parts.constants = constants.str();
    parts.predict = velocity_predict_text(scheme);
    parts.coupled =
        fill_part("velocity_lanes.hpp.in",
                  {{"unknowns", unknowns(block)},
                   {"member", member(scheme)},
                   {"times", times(scheme)},
                   {"newton", scheme.takes_newton() ? newton_of_positions(scheme, block.of(Kind::Q),
                                                                          "s.drifts(system);")
                                                    : ""}});
    parts.members = members_of_lanes(scheme, "VelocityLanes");
    if (wishes.curve) {
        parts.curve = curve_text(
            scheme, *wishes.curve, "s_.increment_q(cn_lanes, static_cast<std::size_t>(k))",
            [](std::size_t i) { return fmt::format("s_.W[static_cast<std::size_t>(k)][{}]", i); });
    }
    return parts;
}

// ---- positions and momenta ----

/// NOTE: for separable H the slopes of p are enough.
std::string pair_predict_text(const Scheme& scheme) {
    return prediction_of_lanes(
        scheme,
        [&](Writer& writer) {
            if (!scheme.separable) {
                writer.line("s_.extrapolate_q({});", extrapolation_of(scheme, "Lq"));
            }
            writer.line("s_.extrapolate_p({});", extrapolation_of(scheme, "Lp"));
        },
        [&](Writer& writer) {
            const std::string_view at = scheme.separable ? "s_.at.q" : "s_.at.q, s_.at.p";
            if (scheme.has_joint_slopes) {
                writer.line("Vector dHdq, dHdp;");
                writer.line("system_.gradient({}, {}dHdq, dHdp);", at, start_time(scheme));
                writer.line("s_.predict_q(dHdp);").line("s_.predict_p(dHdq);");
                return;
            }
            writer.line("auto&& slope = hvi::detail::scratch(s_.slope);");
            if (!scheme.separable) {
                writer.line("system_.dHdp({}, {}slope);", at, start_time(scheme));
                writer.line("s_.predict_q(slope);");
            }
            writer.line("system_.dHdq({}, {}slope);", at, start_time(scheme));
            writer.line("s_.predict_p(slope);");
        });
}

/// Members of the stage equations that evaluate H.
std::string slopes_of_lanes(const Scheme& scheme) {
    const std::string Q = "hvi::detail::load(s.Q)", P = "hvi::detail::load(s.P)";
    Writer writer(2);
    if (scheme.has_joint_slopes) {
        writer.open("void slopes() {{").open("s.slopes([&](auto& dHdq, auto& dHdp) {{");
        writer.line("system.gradient({}, {}{}, dHdq, dHdp);", Q, P, times(scheme));
        return writer.close("});").close().str();
    }
    writer.open("void velocities() {{");
    const std::string both = fmt::format("{}, {}{}", Q, P, times(scheme));
    writer.line("s.velocities([&](auto& out) {{ system.dHdp({}, out); }});",
                scheme.separable ? P : both);
    writer.close().open("void forces() {{");
    writer.line("s.forces([&](auto& out) {{ system.dHdq({}, out); }});",
                scheme.separable ? Q + times(scheme) : both);
    return writer.close().str();
}

ImplicitParts pair_lane_parts(const Scheme& scheme, const SceneWishes& wishes) {
    const Block& block = scheme.blocks.front();
    const std::string stages = std::to_string(scheme.positions.size());
    Writer constants(1);
    constants.insert(pair_constants(scheme, wishes)).blank();
    columns(constants, "m");
    if (!scheme.one_tableau()) { columns(constants, "mt"); }
    columns_of_extrapolation(constants, scheme);
    ImplicitParts parts;
    parts.runtime = {"detail/lanes/stage_lanes"};
    parts.steps = steps_of_lanes(scheme, {}, "");
    parts.constants = constants.str();
    parts.predict = pair_predict_text(scheme);
    parts.coupled = fill_part("pair_lanes.hpp.in",
                              {{"unknowns", unknowns(block)},
                               {"member", member(scheme)},
                               {"stages", stages},
                               {"indices", fmt::format("{}", fmt::join(block.of(Kind::Lq), ", "))},
                               {"separable", std::string(truth(scheme.separable))},
                               {"mt", std::string(table_mt(scheme))},
                               {"slopes", slopes_of_lanes(scheme)}});
    parts.members = members_of_lanes(scheme, "StageLanes");
    if (wishes.curve) {
        parts.curve = curve_text(
            scheme, *wishes.curve, "s_.increment_q(static_cast<std::size_t>(k))",
            [](std::size_t i) { return fmt::format("s_.Lq[static_cast<std::size_t>(k)][{}]", i); });
    }
    return parts;
}

}  // namespace

ImplicitParts lane_parts(const Scheme& scheme, const SceneWishes& wishes) {
    HVI_CHECK(scheme.has_stage_lanes && scheme.blocks.size() == 1);
    return scheme.velocity_form ? velocity_lane_parts(scheme, wishes)
                                : pair_lane_parts(scheme, wishes);
}

}  // namespace hvi::gen
