// Headers of steppers that advance trajectories side by side.
// SPDX-License-Identifier: GPL-2.0-or-later

#include "generator/emit/steps/banner.hpp"
#include "generator/emit/steps/explicit_moves.hpp"
#include "generator/emit/steps/header.hpp"
#include "generator/emit/steps/implicit_parts.hpp"
#include "generator/emit/steps/system_part.hpp"
#include "generator/support/error.hpp"
#include "src/hvi/version.hpp"

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
    parts.runtime = {"detail/trajectories/trajectories"};
    parts.carried = keeps(scheme) ? "SlopeCarried" : "NothingCarried";
    parts.step = ensemble_moves_text(scheme, dimension);
    parts.constants = weights_text(scheme);
    Writer members(1);
    members.line("System system_;");
    if (scheme.keeps_remainder) {
        parts.runtime.insert(parts.runtime.end(), {"detail/coefficients/weights",
                                                   "detail/trajectories/trajectory_sums"});
        parts.carried = keeps(scheme) ? "RemaindersAndSlopeCarried" : "RemaindersCarried";
        parts.reset = "sums_.forget();";
        members.line("hvi::detail::TrajectorySums<State> sums_;")
            .line("{}", weights_member(scheme));
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

/// A vector as functions of lanes take it.
std::string loaded(std::string_view stages, std::string_view vector) {
    return fmt::format("hvi::detail::load({}.{})", stages, vector);
}

/// Where a slope is evaluated: `vectors` and, if H depends on it, the time.
std::string arguments(const Scheme& scheme, std::vector<std::string> vectors,
                      std::string_view time) {
    if (scheme.depends_on_time) { vectors.emplace_back(time); }
    return fmt::format("{}, ", fmt::join(vectors, ", "));
}

constexpr std::string_view start = "s_.clock.start()";  // the time where a step begins
constexpr std::string_view inner = "s.clock.at(c[i])";  // the time of stage i

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
        [&](Writer& out) {
            if (!scheme.depends_on_time) {
                out.line("s_.predict(system_);");
                return;
            }
            out.open("s_.predict(system_, [&](Values& out) {{");
            out.line("system_.dHdq({}, {}, out);", loaded("s_", "q"), start).close("});");
        });
    return writer.insert(solve_and_advance(", c")).str();
}

/// NOTE: for separable H the slopes of p are enough.
std::string pair_step(const Scheme& scheme) {
    const std::string q = loaded("s_", "q"), p = loaded("s_", "p");
    const std::string at = arguments(scheme, {q, p}, start);
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
                out.line("Values dHdq, dHdp;").line("system_.gradient({}dHdq, dHdp);", at);
                out.line("s_.predict_q(dHdp);").line("s_.predict_p(dHdq);");
                return;
            }
            out.line("Values slope;");
            if (!scheme.separable) {
                out.line("system_.dHdp({}slope);", at).line("s_.predict_q(slope);");
            }
            out.line("system_.dHdq({}slope);",
                     scheme.separable ? arguments(scheme, {q}, start) : at);
            out.line("s_.predict_p(slope);");
        });
    return writer.insert(solve_and_advance("")).str();
}

/// The type of what keeps the stages.
std::string stages_type(const Scheme& scheme) {
    return fmt::format("hvi::detail::{}Trajectories<Vector, {}{}>",
                       scheme.velocity_form ? "Velocity" : "Pair", scheme.positions.size(),
                       scheme.depends_on_time ? ", Trajectory" : "");
}

std::string members_text(const Scheme& scheme) {
    return Writer(1)
        .line("System system_;")
        .line("{} s_;", stages_type(scheme))
        .line("hvi::detail::LaneSweeps<Scalar, hvi::detail::fixed_size<Vector>()> solver_;")
        .str();
}

/// The body of the member of the stage equations of positions that evaluates forces.
std::string forces_of_positions(const Scheme& scheme) {
    if (!scheme.depends_on_time) { return "s.forces(system, lanes);"; }
    return Writer(2)
        .line("s.forces(system, lanes, [&](std::size_t i, Values& out) {{ system.dHdq({}, {}, "
              "out); }});",
              loaded("s", "Q[i]"), inner)
        .str();
}

/// Members of the stage equations that evaluate H.
std::string slopes_text(const Scheme& scheme) {
    const std::string Q = loaded("s", "Q[i]"), P = loaded("s", "P[i]");
    const std::string both = arguments(scheme, {Q, P}, inner);
    const std::string_view lanes = "const typename State::Mask& lanes";
    Writer writer(2);
    if (scheme.has_joint_slopes) {
        writer.open("void slopes({}) {{", lanes);
        writer.open("s.slopes(lanes, [&](std::size_t i, Values& dHdq, Values& dHdp) {{");
        writer.line("system.gradient({}dHdq, dHdp);", both);
        return writer.close("});").close().str();
    }
    writer.open("void velocities({}) {{", lanes);
    writer.line("s.velocities(lanes, [&](std::size_t i, Values& out) {{ system.dHdp({}out); }});",
                scheme.separable ? P + ", " : both);
    writer.close().open("void forces({}) {{", lanes);
    writer.line("s.forces(lanes, [&](std::size_t i, Values& out) {{ system.dHdq({}out); }});",
                scheme.separable ? arguments(scheme, {Q}, inner) : both);
    return writer.close().str();
}

EnsembleParts implicit_parts(const Scheme& scheme) {
    HVI_CHECK(scheme.blocks.size() == 1);
    const std::string about = unknowns(scheme.blocks.front());
    EnsembleParts parts;
    parts.runtime = {"detail/trajectories/trajectory_stages"};
    parts.carried = "RemaindersCarried";
    parts.reset = "s_.forget();";
    if (scheme.velocity_form) {
        parts.step = velocity_step(scheme);
        parts.constants = velocity_constants(scheme, {});
        parts.coupled =
            fill_part("velocity_ensemble.hpp.in", {{"unknowns", about},
                                                   {"trajectories", stages_type(scheme)},
                                                   {"forces", forces_of_positions(scheme)}});
        parts.members = members_text(scheme);
        return parts;
    }
    parts.step = pair_step(scheme);
    parts.constants = pair_constants(scheme, {});
    parts.coupled =
        fill_part("pair_ensemble.hpp.in", {{"unknowns", about},
                                           {"trajectories", stages_type(scheme)},
                                           {"separable", std::string(truth(scheme.separable))},
                                           {"mt", std::string(table_mt(scheme))},
                                           {"slopes", slopes_text(scheme)}});
    parts.members = members_text(scheme);
    return parts;
}

std::string state_type(const Scheme& scheme, std::string_view carried) {
    return fmt::format("hvi::Trajectories<Vector, hvi::detail::{}{}>", carried,
                       scheme.depends_on_time ? ", Trajectory" : "");
}

}  // namespace

std::string emit_ensemble(const Tableau& tableau, const Scheme& scheme,
                          const EmitOptions& options) {
    HVI_CHECK(options.scene != nullptr);
    const SystemPart system = system_part(tableau, scheme, options);
    EnsembleParts parts = scheme.is_explicit()
                              ? explicit_parts(scheme, options.scene->system.degrees_of_freedom())
                              : implicit_parts(scheme);
    Holes holes = holes_of(system);
    holes.merge(Holes{{"banner", banner(tableau, scheme, options)},
                      {"format", std::to_string(hvi::runtime_format)},
                      {"runtime", runtime_includes(std::move(parts.runtime))},
                      {"trajectory", system.state},
                      {"state", state_type(scheme, parts.carried)},
                      {"step", parts.step},
                      {"reset", parts.reset},
                      {"constants", parts.constants},
                      {"coupled", parts.coupled},
                      {"members", parts.members}});
    return fill("ensemble.hpp.in", holes);
}

}  // namespace hvi::gen
