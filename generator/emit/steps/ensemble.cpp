// Headers of steppers that advance trajectories side by side.
// SPDX-License-Identifier: GPL-2.0-or-later

#include "generator/emit/steps/clock.hpp"
#include "generator/emit/steps/explicit_moves.hpp"
#include "generator/emit/steps/header.hpp"
#include "generator/emit/steps/implicit_parts.hpp"
#include "generator/emit/steps/slope_calls.hpp"
#include "generator/emit/steps/system_part.hpp"
#include "generator/support/error.hpp"
#include "src/hvi/version.hpp"

namespace hvi::gen {
namespace {

/// Parts of the header; see templates/ensemble.hpp.in.
struct EnsembleParts {
    std::vector<std::string> runtime;
    std::string carried, step, resize, reset_lane, reset, constants, coupled, members;
};

/// Returns the members that evaluate H, of one trajectory and of eight.
std::string systems_text() {
    return Writer(1)
        .line("System one_;")
        .line("LaneSystem system_;")
        .line("hvi::detail::TrajectoryRow<Scalar> h_{{}};")
        .line("Scalar common_h_ = 0;  ///< h of all lanes, or 0")
        .str();
}

// ---- explicit ----

EnsembleParts ensemble_parts(const Step& step, const ExplicitStep& form, std::size_t dimension) {
    EnsembleParts parts;
    parts.runtime = {"detail/trajectories/trajectories"};
    parts.step = ensemble_moves_text(step, form.sums, dimension);
    parts.constants = weights_text(step);
    if (form.sums == Sums::plain) {
        parts.carried = step.kept.any() ? "SlopeCarried" : "NothingCarried";
        parts.members = systems_text();
        return parts;
    }
    parts.carried = step.kept.any() ? "RemaindersAndSlopeCarried" : "RemaindersCarried";
    parts.runtime.insert(parts.runtime.end(), {"detail/trajectories/trajectory_sums",
                                               "detail/trajectories/trajectory_weights"});
    parts.resize = "weights_.weigh(lane, h, b_p, b_q);";
    parts.reset = "sums_.forget();";
    parts.members = Writer(1)
                        .insert(systems_text())
                        .line("hvi::detail::TrajectorySums<State> sums_;")
                        .line("{}", weights_member(step))
                        .str();
    return parts;
}

EnsembleParts ensemble_parts(const Step&, const ChartStep&, std::size_t) {
    HVI_CHECK(false && "there are no ensembles in charts");
    return {};
}

EnsembleParts ensemble_parts(const Step&, const FlowStep&, std::size_t) {
    HVI_CHECK(false);
    return {};
}

EnsembleParts ensemble_parts(const Step&, const GalerkinStep&, std::size_t) {
    HVI_CHECK(false);
    return {};
}

EnsembleParts ensemble_parts(const Step&, const TabulatedStep&, std::size_t) {
    HVI_CHECK(false);  // it has no such layout
    return {};
}

// ---- implicit ----

/// Returns the lines that solve and end the step. `system` is the first argument of the call at the
/// end, and `table` its last one.
std::string solve_and_advance(std::string_view system, std::string_view table) {
    return Writer(2)
        .blank()
        .line("const auto outcome = solver_.solve(Coupled{{system_, s_}}, x.going());")
        .line("return s_.advance({}x, outcome{});", system, table)
        .str();
}

/// Returns a vector in the form that functions of lanes take.
std::string loaded(std::string_view stages, std::string_view vector) {
    return fmt::format("hvi::detail::load({}.{})", stages, vector);
}

/// Returns the point at the start of a step. inner() returns the point of stage i.
SlopePoint start(const Step& step) {
    return {loaded("s_", "q"), loaded("s_", "p"), time_of_trajectories(step, "s_.clock.start()")};
}

SlopePoint inner(const Step& step) {
    return {loaded("s", "Q[i]"), loaded("s", "P[i]"),
            time_of_trajectories(step, "s.clock.at(c[i])")};
}

/// Writes the starting values. constant() takes those of `lanes`.
void predict(Writer& writer, const Iteration& iteration, const auto& extrapolated,
             const auto& constant) {
    if (iteration.extrapolation.empty()) {
        writer.line("const Mask lanes(true);");
        constant(writer);
        return;
    }
    writer.open("if (s_.some_go_on) {{");
    extrapolated(writer);
    writer.close().open("if (s_.some_begin) {{");
    writer.line("const Mask lanes = s_.new_lanes();");
    constant(writer);
    writer.close();
}

std::string velocity_step(const Step& step, const Iteration& iteration) {
    Writer writer(2);
    writer.line("if (!s_.begin(x)) {{ return x.status(); }}");
    writer.line("s_.drift_freely(system_, c);");
    predict(
        writer, iteration, [](Writer& out) { out.line("s_.extrapolate(N);"); },
        [&](Writer& out) {
            if (!step.depends_on_time()) {
                out.line("s_.predict(system_, lanes);");
                return;
            }
            out.open("s_.predict(system_, lanes, [&](Values& out) {{");
            out.line("system_.{};", force_call(step, start(step), "out")).close("});");
        });
    return writer.insert(solve_and_advance("system_, ", ", c")).str();
}

/// NOTE: for separable H the slopes of p are enough.
std::string pair_step(const Step& step, const Iteration& iteration) {
    const SlopePoint at = start(step);
    Writer writer(2);
    writer.line("if (!s_.begin(x)) {{ return x.status(); }}");
    predict(
        writer, iteration,
        [&](Writer& out) {
            if (!step.is_separable()) { out.line("s_.extrapolate_q(N);"); }
            out.line("s_.extrapolate_p(N);");
        },
        [&](Writer& out) {
            if (step.slopes == Slopes::joint) {
                out.line("Values dHdq, dHdp;");
                out.line("system_.{};", gradient_call(at, "dHdq", "dHdp"));
                out.line("s_.predict_q(lanes, dHdp);").line("s_.predict_p(lanes, dHdq);");
                return;
            }
            out.line("Values slope;");
            if (!step.is_separable()) {
                out.line("system_.{};", velocity_call(step, at, "slope"));
                out.line("s_.predict_q(lanes, slope);");
            }
            out.line("system_.{};", force_call(step, at, "slope"))
                .line("s_.predict_p(lanes, slope);");
        });
    return writer.insert(solve_and_advance("", "")).str();
}

/// Returns the type of the stages.
std::string stages_type(const Step& step, std::string_view kind) {
    return fmt::format("hvi::detail::{}Trajectories<Vector, {}{}>", kind, step.positions.size(),
                       trajectory_argument(step));
}

std::string members_text(const Iteration& iteration, const std::string& stages) {
    constexpr std::string_view numbers = "Scalar, hvi::detail::fixed_size<Vector>()";
    return Writer(1)
        .insert(systems_text())
        .line("{} s_;", stages)
        .line("hvi::detail::{} solver_;",
              iteration.counts_sweeps()
                  ? fmt::format("CountedLaneSweeps<{}, {}>", numbers, iteration.sweeps)
                  : fmt::format("LaneSweeps<{}>", numbers))
        .str();
}

/// Returns the body of the member that evaluates forces, in the stage equations of positions.
std::string forces_of_positions(const Step& step) {
    if (!step.depends_on_time()) { return "s.forces(system, lanes);"; }
    return Writer(2)
        .line("s.forces(system, lanes, [&](std::size_t i, Values& out) {{ system.{}; }});",
              force_call(step, inner(step), "out"))
        .str();
}

/// Returns the members of the stage equations that evaluate H.
std::string slopes_text(const Step& step) {
    const SlopePoint at = inner(step);
    const std::string_view lanes = "const typename State::Mask& lanes";
    Writer writer(2);
    if (step.slopes == Slopes::joint) {
        writer.open("void slopes({}) {{", lanes);
        writer.open("s.slopes(lanes, [&](std::size_t i, Values& dHdq, Values& dHdp) {{");
        writer.line("system.{};", gradient_call(at, "dHdq", "dHdp"));
        return writer.close("});").close().str();
    }
    writer.open("void velocities({}) {{", lanes);
    writer.line("s.velocities(lanes, [&](std::size_t i, Values& out) {{ system.{}; }});",
                velocity_call(step, at, "out"));
    writer.close().open("void forces({}) {{", lanes);
    writer.line("s.forces(lanes, [&](std::size_t i, Values& out) {{ system.{}; }});",
                force_call(step, at, "out"));
    return writer.close().str();
}

/// Returns the common parts of both implicit forms.
EnsembleParts implicit_parts(const Iteration& iteration, const std::string& stages) {
    EnsembleParts parts;
    parts.runtime = {"detail/trajectories/trajectory_stages"};
    parts.carried = "RemaindersCarried";
    parts.resize = "s_.resize(lane, h, b);";
    parts.reset_lane = "s_.forget(lane);";
    parts.reset = "s_.forget();";
    parts.members = members_text(iteration, stages);
    return parts;
}

EnsembleParts ensemble_parts(const Step& step, const VelocityStep& form, std::size_t) {
    const std::string stages = stages_type(step, "Velocity");
    EnsembleParts parts = implicit_parts(form.iteration, stages);
    parts.step = velocity_step(step, form.iteration);
    parts.constants = constants_text(step, form, {});
    parts.coupled =
        fill_part("velocity_ensemble.hpp.in", {{"unknowns", unknowns(step.blocks.front())},
                                               {"trajectories", stages},
                                               {"forces", forces_of_positions(step)}});
    return parts;
}

EnsembleParts ensemble_parts(const Step& step, const PairStep& form, std::size_t) {
    HVI_CHECK(form.iteration.has_value());
    const std::string stages = stages_type(step, "Pair");
    EnsembleParts parts = implicit_parts(*form.iteration, stages);
    parts.step = pair_step(step, *form.iteration);
    parts.constants = constants_text(step, form, {});
    parts.coupled =
        fill_part("pair_ensemble.hpp.in", {{"unknowns", unknowns(step.blocks.front())},
                                           {"trajectories", stages},
                                           {"separable", std::string(truth(step.is_separable()))},
                                           {"mt", std::string(table_mt(step))},
                                           {"slopes", slopes_text(step)}});
    return parts;
}

}  // namespace

std::string emit_ensemble(const OneStepMethod& method, const Step& step,
                          const EmitOptions& options) {
    HVI_CHECK(options.system != nullptr);
    const SystemPart system = system_part(method, step, options);
    const std::size_t dimension = options.system->degrees_of_freedom();
    EnsembleParts parts = std::visit(
        [&](const auto& form) { return ensemble_parts(step, form, dimension); }, step.form);
    Holes holes = holes_of(system);
    holes.merge(Holes{{"format", std::to_string(hvi::runtime_format)},
                      {"runtime", runtime_includes(std::move(parts.runtime))},
                      {"trajectory", system.state},
                      {"state", fmt::format("hvi::Trajectories<Vector, hvi::detail::{}{}>",
                                            parts.carried, trajectory_argument(step))},
                      {"step", parts.step},
                      {"resize", parts.resize},
                      {"reset_lane", parts.reset_lane},
                      {"reset", parts.reset},
                      {"constants", parts.constants},
                      {"coupled", parts.coupled},
                      {"members", parts.members}});
    return fill("ensemble.hpp.in", holes);
}

}  // namespace hvi::gen
