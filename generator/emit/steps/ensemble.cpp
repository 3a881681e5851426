// Headers of steppers that advance trajectories side by side.
// SPDX-License-Identifier: GPL-2.0-or-later

#include "generator/emit/steps/clock.hpp"
#include "generator/emit/steps/explicit_moves.hpp"
#include "generator/emit/steps/flow_form.hpp"
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

EnsembleParts ensemble_parts(const Step& step, const ExplicitStep& form, const System& system) {
    EnsembleParts parts;
    parts.runtime = {"detail/trajectories/trajectories"};
    parts.step = ensemble_moves_text(step, form.sums, system.degrees_of_freedom());
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

EnsembleParts ensemble_parts(const Step&, const ChartStep&, const System&) {
    HVI_CHECK(false && "there are no ensembles in charts");
    return {};
}

EnsembleParts ensemble_parts(const Step&, const GalerkinStep&, const System&) {
    HVI_CHECK(false);
    return {};
}

EnsembleParts ensemble_parts(const Step&, const TabulatedStep&, const System&) {
    HVI_CHECK(false);  // it has no such layout
    return {};
}

// ---- flows of parts of H ----

/// Returns the flows of a step, between its begin and its end.
std::string flow_step_text(const FlowStep& form, std::string_view path) {
    return Writer(2)
        .line("if (!sums_.begin(x, h_)) {{ return x.status(); }}")
        .line("if (changed_.any()) {{ set_flows(); }}")
        .line("hvi::detail::{}<State> path(x);", path)
        .insert(rounds_text(form))
        .line("path.end(x);")
        .line("return x.status();")
        .str();
}

/// Returns the classes of the flows, and the member that computes those of lanes that changed.
std::string flow_classes_text(const System& system, const FlowStep& form) {
    Writer writer(1);
    writer
        .insert(flows_text(system, form, "hvi::math", Constants::are_of_template, Carries::nothing))
        .blank();
    writer.open("[[gnu::noinline]] void set_flows() {{")
        .open("changed_.take([&](std::size_t lane) {{");
    for (std::size_t k = 0; k < form.fractions.size(); ++k) {
        writer.open("for (std::size_t i = 0; i < {}; ++i) {{", form.fractions[k].size())
            .line("const Flow{0} one(parameters_[lane], h_[lane] * fractions_{0}[i]);", k + 1)
            .line("flows_{}_[i].set(lane, one);", k + 1)
            .close();
    }
    return writer.close("});").close().str();
}

EnsembleParts ensemble_parts(const Step&, const FlowStep& form, const System& system) {
    const bool moves_by_matrices = moves_forms(*system.parts);
    EnsembleParts parts;
    parts.runtime = {"detail/trajectories/trajectory_flows"};
    parts.coupled = flow_classes_text(system, form);
    if (rotations_of(system) > 0) {
        parts.runtime.emplace_back("detail/trajectories/trajectory_bodies");
    }
    const bool has_small_turns = parts.coupled.find("hvi::math::small_") != std::string::npos;
    if (has_small_turns || calls(*system.parts, RuntimeFunction::turn_about_momentum)) {
        parts.runtime.emplace_back("detail/lanes/lane_turns");
    }
    if (moves_by_matrices) { parts.runtime.emplace_back("detail/stages/form_flow"); }
    if (calls(*system.parts, RuntimeFunction::orbits)) {
        parts.runtime.emplace_back("detail/trajectories/trajectory_orbits");
    }
    parts.carried = "RemaindersCarried";
    parts.step = flow_step_text(form, moves_by_matrices ? "LongTrajectoryPath" : "TrajectoryPath");
    parts.resize = "changed_.add(lane);";
    parts.reset = "sums_.forget();";
    parts.constants = fractions_text(form);
    Writer members(1);
    members.insert(systems_text())
        .line("std::array<Parameters, hvi::trajectories_at_once> parameters_;")
        .line("hvi::detail::ChangedLanes changed_;  ///< since the flows were computed");
    for (std::size_t k = 0; k < form.fractions.size(); ++k) {
        members.line("LaneFlow{0} flows_{0}_[{1}];", k + 1, form.fractions[k].size());
    }
    parts.members = members.line("hvi::detail::TrajectorySums<State> sums_;").str();
    return parts;
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

EnsembleParts ensemble_parts(const Step& step, const VelocityStep& form, const System&) {
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

EnsembleParts ensemble_parts(const Step& step, const PairStep& form, const System&) {
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

/// Returns the type of eight trajectories.
std::string state_of_ensemble(const Step& step, const SystemPart& part, const System& system,
                              std::string_view carried) {
    if (vectors_of(system) == StateVectors::bodies) {
        return fmt::format("hvi::Trajectories<hvi::detail::BodyVectors<Space, {}>,\n"
                           "                                    hvi::detail::{}, {}>",
                           part.class_name, carried, part.state);
    }
    return fmt::format("hvi::Trajectories<Vector, hvi::detail::{}{}>", carried,
                       trajectory_argument(step));
}

}  // namespace

std::string emit_ensemble(const OneStepMethod& method, const Step& step,
                          const EmitOptions& options) {
    HVI_CHECK(options.system != nullptr);
    const SystemPart system = system_part(method, step, options);
    EnsembleParts parts = std::visit(
        [&](const auto& form) { return ensemble_parts(step, form, *options.system); }, step.form);
    Holes holes = holes_of(system);
    holes.merge(Holes{{"format", std::to_string(hvi::runtime_format)},
                      {"runtime", runtime_includes(std::move(parts.runtime))},
                      {"trajectory", system.state},
                      {"state", state_of_ensemble(step, system, *options.system, parts.carried)},
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
