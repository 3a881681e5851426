// Headers of steppers that advance trajectories side by side.
// SPDX-License-Identifier: GPL-2.0-or-later

#include "generator/emit/steps/banner.hpp"
#include "generator/emit/steps/explicit_moves.hpp"
#include "generator/emit/steps/header.hpp"
#include "generator/emit/steps/implicit_parts.hpp"
#include "generator/emit/steps/system_part.hpp"
#include "generator/plan/equal.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {
namespace {

/// See templates/ensemble.hpp.in.
struct EnsembleParts {
    std::vector<std::string> runtime;
    std::string carried, step, reset, constants, coupled, members;
};

// ---- explicit ----

void write_move(Writer& writer, const Scheme& scheme, const Move& move, bool is_first,
                std::size_t dimension) {
    const std::string_view slope = keeps(scheme, move.kick) ? "kept" : "slope";
    const std::string evaluate = fmt::format("system_.{}({}, {});", move.kick ? "dHdq" : "dHdp",
                                             move.kick ? "q" : "p", slope);
    if (keeps(scheme, move.kick) && is_first) {
        writer.line("if (!x.carried.is_known) {{ {} }}", evaluate);
    } else {
        writer.line("{}", evaluate);
    }
    const StageValue& value = (move.kick ? scheme.positions : scheme.momenta)[move.index];
    const std::string factor =
        equal(value.weight, 1) ? "h"
                               : fmt::format("(h * {}[{}])", move.kick ? "b_p" : "b_q", move.index);
    const auto add = [&](std::string_view k) {
        writer.line("{0}[{4}] = {0}[{4}] {1} {2} * {3}[{4}];", move.kick ? "p" : "q",
                    move.kick ? "-" : "+", factor, slope, k);
    };
    // NOTE: a few are written out, so that compilers keep them in registers also below -O3.
    constexpr std::size_t few = 4;
    if (dimension <= few) {
        for (std::size_t k = 0; k < dimension; ++k) { add(std::to_string(k)); }
        return;
    }
    writer.open("for (std::size_t k = 0; k < q.size(); ++k) {{");
    add("k");
    writer.close();
}

std::string explicit_step(const Scheme& scheme, std::size_t dimension) {
    const std::vector<Move> all = moves(scheme);
    Writer writer(2);
    writer.line("if (!x.begins(h)) {{ return x.status(); }}");
    writer.line("Values q = hvi::detail::load(x.q);").line("Values p = hvi::detail::load(x.p);");
    writer.line("Values slope;");
    if (keeps(scheme)) { writer.line("Values kept = hvi::detail::load(x.carried.slope);"); }
    writer.blank();
    for (std::size_t i = 0; i < all.size(); ++i) {
        write_move(writer, scheme, all[i], i == 0, dimension);
    }
    writer.blank();
    if (keeps(scheme)) {
        writer.open("x.end(q, p, hvi::detail::where_finite(q, p), [&](auto put) {{");
        writer.line("put(kept, x.carried.slope);");
        writer.line("x.carried.is_known = true;").close("});");
    } else {
        writer.line("x.end(q, p, hvi::detail::where_finite(q, p));");
    }
    return writer.line("return x.status();").str();
}

EnsembleParts explicit_parts(const Scheme& scheme, std::size_t dimension) {
    EnsembleParts parts;
    parts.runtime = {"trajectories.hpp"};
    parts.carried = keeps(scheme) ? "SlopeCarried" : "NothingCarried";
    parts.step = explicit_step(scheme, dimension);
    parts.constants = weights_text(scheme);
    parts.members = Writer(1).line("System system_;").str();
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

}  // namespace

std::string emit_ensemble(const Tableau& tableau, const Scheme& scheme,
                          const EmitOptions& options) {
    HVI_CHECK(options.scene != nullptr);
    const SystemPart system = system_part(tableau, scheme, options);
    EnsembleParts parts = scheme.is_explicit()
                              ? explicit_parts(scheme, options.scene->system.degrees_of_freedom())
                              : implicit_parts(scheme);
    return fill("ensemble.hpp.in", {{"banner", banner(tableau, scheme, options)},
                                    {"format", scheme.has_joint_slopes ? "8" : "7"},
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
