// Headers of steppers that advance trajectories side by side.
// SPDX-License-Identifier: GPL-2.0-or-later

#include "generator/emit/banner.hpp"
#include "generator/emit/explicit_moves.hpp"
#include "generator/emit/header.hpp"
#include "generator/emit/implicit_parts.hpp"
#include "generator/emit/system_part.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {
namespace {

/// See templates/ensemble.hpp.in.
struct EnsembleParts {
    std::vector<std::string> runtime;
    std::string carried, step, reset, constants, coupled, members;
};

// ---- explicit ----

EnsembleParts explicit_parts(const Scheme& scheme, std::size_t dimension) {
    EnsembleParts parts;
    parts.runtime = {"trajectories.hpp"};
    parts.carried = keeps(scheme) ? "SlopeCarried" : "NothingCarried";
    parts.step = ensemble_moves_text(scheme, dimension);
    parts.constants = weights_text(scheme);
    Writer members(1);
    members.line("System system_;");
    if (scheme.keeps_remainder) {
        parts.runtime.emplace_back("trajectory_sums.hpp");
        parts.carried = keeps(scheme) ? "RemaindersAndSlopeCarried" : "RemaindersCarried";
        parts.reset = "sums_.forget();";
        members.line("hvi::detail::TrajectorySums<State> sums_;");
    }
    parts.members = members.str();
    return parts;
}

// ---- implicit ----

std::string solve_and_advance(std::string_view arguments) {
    return Writer(2)
        .blank()
        .line("const auto outcome = solver_.solve(Coupled{{system_, s_}}, x.going());")
        .line("return s_.advance(x, outcome{});", arguments)
        .str();
}

/// The starting values.
void predict(Writer& writer, const Scheme& scheme, const auto& extrapolated, const auto& constant) {
    if (!scheme.extrapolation) {
        constant(writer);
        return;
    }
    writer.open("if (s_.extrapolates) {{");
    extrapolated(writer);
    writer.close().open("if (!s_.extrapolates) {{");
    constant(writer);
    writer.close();
}

std::string velocity_step(const Scheme& scheme) {
    Writer writer(2);
    writer.line("if (!s_.begin(x, h, b)) {{ return x.status(); }}");
    writer.line("s_.begin_drift(system_);").line("s_.drift_freely(c);");
    predict(
        writer, scheme, [](Writer& out) { out.line("s_.extrapolate(N);"); },
        [](Writer& out) { out.line("s_.predict(system_);"); });
    return writer.insert(solve_and_advance(", c")).str();
}

/// NOTE: for separable H the slopes of p are enough.
std::string pair_step(const Scheme& scheme) {
    const std::string_view at = scheme.separable
                                    ? "hvi::detail::load(s_.q)"
                                    : "hvi::detail::load(s_.q), hvi::detail::load(s_.p)";
    Writer writer(2);
    writer.line("if (!s_.begin(x, h, b)) {{ return x.status(); }}");
    predict(
        writer, scheme,
        [&](Writer& out) {
            if (!scheme.separable) { out.line("s_.extrapolate_q(N);"); }
            out.line("s_.extrapolate_p(N);");
        },
        [&](Writer& out) {
            if (scheme.has_joint_slopes) {
                out.line("Values dHdq, dHdp;").line("system_.gradient({}, dHdq, dHdp);", at);
                out.line("s_.predict_q(dHdp);").line("s_.predict_p(dHdq);");
                return;
            }
            out.line("Values slope;");
            if (!scheme.separable) {
                out.line("system_.dHdp({}, slope);", at).line("s_.predict_q(slope);");
            }
            out.line("system_.dHdq({}, slope);", at).line("s_.predict_p(slope);");
        });
    return writer.insert(solve_and_advance("")).str();
}

std::string members_text(const Scheme& scheme, std::string_view stages) {
    return Writer(1)
        .line("System system_;")
        .line("hvi::detail::{}<Vector, {}> s_;", stages, scheme.positions.size())
        .line("hvi::detail::LaneSweeps<Scalar, hvi::detail::fixed_size<Vector>()> solver_;")
        .str();
}

/// Members of the stage equations that evaluate H.
std::string slopes_text(const Scheme& scheme) {
    const std::string Q = "hvi::detail::load(s.Q[i])", P = "hvi::detail::load(s.P[i])";
    const std::string both = Q + ", " + P;
    const std::string_view lanes = "const typename State::Mask& lanes";
    Writer writer(2);
    if (scheme.has_joint_slopes) {
        writer.open("void slopes({}) {{", lanes);
        writer.open("s.slopes(lanes, [&](std::size_t i, Values& dHdq, Values& dHdp) {{");
        writer.line("system.gradient({}, dHdq, dHdp);", both);
        return writer.close("});").close().str();
    }
    writer.open("void velocities({}) {{", lanes);
    writer.line("s.velocities(lanes, [&](std::size_t i, Values& out) {{ system.dHdp({}, out); }});",
                scheme.separable ? P : both);
    writer.close().open("void forces({}) {{", lanes);
    writer.line("s.forces(lanes, [&](std::size_t i, Values& out) {{ system.dHdq({}, out); }});",
                scheme.separable ? Q : both);
    return writer.close().str();
}

EnsembleParts implicit_parts(const Scheme& scheme) {
    HVI_CHECK(scheme.blocks.size() == 1);
    const std::string about = unknowns(scheme.blocks.front());
    EnsembleParts parts;
    parts.runtime = {"lane_sweeps.hpp", "trajectories.hpp", "trajectory_stages.hpp"};
    parts.carried = "RemaindersCarried";
    parts.reset = "s_.forget();";
    if (scheme.velocity_form) {
        parts.step = velocity_step(scheme);
        parts.constants = velocity_constants(scheme, {});
        parts.coupled = fill_part("velocity_ensemble.hpp.in", {{"unknowns", about}});
        parts.members = members_text(scheme, "VelocityTrajectories");
        return parts;
    }
    parts.step = pair_step(scheme);
    parts.constants = pair_constants(scheme, {});
    parts.coupled =
        fill_part("pair_ensemble.hpp.in", {{"unknowns", about},
                                           {"stages", std::to_string(scheme.positions.size())},
                                           {"separable", std::string(truth(scheme.separable))},
                                           {"mt", std::string(table_mt(scheme))},
                                           {"slopes", slopes_text(scheme)}});
    parts.members = members_text(scheme, "PairTrajectories");
    return parts;
}

std::string format(const Scheme& scheme) {
    return scheme.is_explicit() ? "9" : scheme.has_joint_slopes ? "8" : "7";
}

}  // namespace

std::string emit_ensemble(const Tableau& tableau, const Scheme& scheme,
                          const EmitOptions& options) {
    HVI_CHECK(options.scene != nullptr);
    const SystemPart system = system_part(tableau, scheme, options);
    EnsembleParts parts = scheme.is_explicit()
                              ? explicit_parts(scheme, options.scene->system.degrees_of_freedom())
                              : implicit_parts(scheme);
    return fill("ensemble.hpp.in", {{"banner", banner(tableau, scheme, options)},
                                    {"format", format(scheme)},
                                    {"name", system.class_name},
                                    {"include", system.include},
                                    {"runtime", runtime_includes(std::move(parts.runtime))},
                                    {"purpose", system.purpose},
                                    {"head", system.head},
                                    {"condition", system.condition},
                                    {"types", system.types},
                                    {"carried", parts.carried},
                                    {"construct", system.construct},
                                    {"alias", system.alias},
                                    {"step", parts.step},
                                    {"reset", parts.reset},
                                    {"constants", parts.constants},
                                    {"coupled", parts.coupled},
                                    {"members", parts.members}});
}

}  // namespace hvi::gen
