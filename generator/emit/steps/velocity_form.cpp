// Stage equations of positions alone.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include "generator/emit/steps/along.hpp"
#include "generator/emit/steps/clock.hpp"
#include "generator/emit/steps/implicit_parts.hpp"
#include "generator/emit/steps/increments.hpp"
#include "generator/emit/steps/slope_calls.hpp"
#include "generator/emit/steps/starting_values.hpp"
#include "generator/ir/equal.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {
namespace {

using Kind = StageNode::Kind;
using Place = StageValue::Place;

/// A loop over the components of a vector; `s` is s_ in the stepper and s in its struct.
void for_components(Writer& writer, std::string_view s, const auto& lines) {
    writer.open("for (Index k = 0; k < {}.at.q.size(); ++k) {{", s);
    lines();
    writer.close();
}

/// Q_i = q + (e_q + c_i w + sum_j n_ij W_j).
std::string position(const VelocityForm& form, std::size_t i, std::string_view s) {
    Increment sum;
    sum.add(1, "", fmt::format("{}.drifted[{}][k]", s, i));
    for (std::size_t j = 0; j < form.c.size(); ++j) {
        sum.add(form.n[i][j], fmt::format("n[{}][{}]", i, j), fmt::format("{}.W[{}][k]", s, j));
    }
    return fmt::format("hvi::detail::moved({}.at.q[k], {})", s, sum.text());
}

// ---- the coupled stages ----

const Block& coupled_block(const Step& step) {
    for (const Block& block : step.blocks) {
        if (block.coupled) { return block; }
    }
    HVI_CHECK(false);
    return step.blocks.front();
}

/// Whether the stages that are solved for need the W of all. NOTE: a W that is not needed may have
/// been left by a step that failed.
bool needs_all(const VelocityForm& form, const std::vector<std::size_t>& Q) {
    return std::all_of(Q.begin(), Q.end(), [&](std::size_t i) {
        return std::none_of(form.n[i].begin(), form.n[i].end(),
                            [](const Number& entry) { return equal(entry, 0); });
    });
}

std::string positions_text(const Step& step, const VelocityForm& form,
                           const std::vector<std::size_t>& Q) {
    Writer writer(2);
    if (step.layout == Layout::components && needs_all(form, Q)) {
        return writer
            .line("hvi::detail::move_stages(s, n, std::array<std::size_t, {}>{{{{{}}}}});",
                  Q.size(), fmt::join(Q, ", "))
            .str();
    }
    for_components(writer, "s", [&] {
        std::string change;
        for (const std::size_t i : Q) {
            writer.line("const Scalar Q_{} = {};", i + 1, position(form, i, "s"));
            change += fmt::format("{}hvi::detail::abs(Q_{} - s.Q[{}][k])",
                                  change.empty() ? "" : " + ", i + 1, i);
        }
        writer.line("s.change.q[k] = {};", change);
        for (const std::size_t i : Q) { writer.line("s.Q[{}][k] = Q_{};", i, i + 1); }
    });
    return writer.str();
}

/// W_i from Lp_i.
void write_velocity(Writer& writer, std::string_view i, std::string_view s,
                    std::string_view system) {
    writer.line("{}.drift({}, {});", s, system, i);
}

/// Lp_i and W_i from `slope`, which is dH/dq there.
void write_force(Writer& writer, std::size_t i, std::string_view s, std::string_view system,
                 std::string_view slope) {
    for_components(writer, s,
                   [&] { writer.line("{0}.Lp[{1}][k] = -{0}.hb[{1}] * {2}[k];", s, i, slope); });
    write_velocity(writer, std::to_string(i), s, system);
}

std::string forces_text(const Step& step, const std::vector<std::size_t>& Lp) {
    Writer writer(2);
    if (step.layout == Layout::components) {
        for (const std::size_t i : Lp) {
            const std::string time = time_of_stage(step, std::to_string(i), "s");
            writer.line("system.kick_stage(s, {}{}{});", i, time.empty() ? "" : ", ", time);
        }
        return writer.str();
    }
    writer.line("auto&& slope = hvi::detail::scratch(s.slope);");
    for (const std::size_t i : Lp) {
        const SlopePoint at{fmt::format("s.Q[{}]", i), "",
                            time_of_stage(step, std::to_string(i), "s")};
        writer.line("system.{};", force_call(step, at, "slope"));
        write_force(writer, i, "s", "system", "slope");
    }
    return writer.str();
}

std::string drifts_text() {
    Writer writer(3);
    writer.open("for (const std::size_t j : unknown) {{");
    write_velocity(writer, "j", "s", "system");
    return writer.close().str();
}

/// See hvi::NewtonTaylor.
std::string taylor_text(const Step& step, const std::vector<std::size_t>& unknown) {
    Writer writer(2);
    writer.line("static constexpr std::array<std::size_t, {}> unknown{{{}}};", unknown.size(),
                fmt::join(unknown, ", "));
    writer.blank().comment("The same, with the tangents of dH/dq at Q.", "/// ");
    writer.open("void forces_and_tangents() {{");
    writer.line("auto&& slope = hvi::detail::scratch(s.slope);");
    writer.open("for (const std::size_t j : unknown) {{");
    const SlopePoint at{"s.Q[j]", "", time_of_stage(step, "j", "s")};
    writer.line("system.{};", force_call(step, at, "slope, tangents.at[j]"));
    for_components(writer, "s", [&] { writer.line("s.Lp[j][k] = -s.hb[j] * slope[k];"); });
    write_velocity(writer, "j", "s", "system");
    writer.line("tangents.Q[j] = s.Q[j];").line("tangents.Lp[j] = s.Lp[j];");
    writer.close().close().blank();
    writer.comment("Lp_j = -h b_j (dH/dq + d2H/dq2 (Q_j - Q)), both at the Q of these tangents.",
                   "/// ");
    writer.open("void forces_by_tangents() {{");
    writer.line("auto&& slope = hvi::detail::scratch(s.slope);").line("Vector way{{}};");
    writer.open("for (const std::size_t j : unknown) {{");
    for_components(writer, "s", [&] { writer.line("way[k] = s.Q[j][k] - tangents.Q[j][k];"); });
    writer.line("system.d2Hdq2(tangents.Q[j], tangents.at[j], way, slope);");
    for_components(writer, "s",
                   [&] { writer.line("s.Lp[j][k] = tangents.Lp[j][k] - s.hb[j] * slope[k];"); });
    write_velocity(writer, "j", "s", "system");
    return writer.close().close().str();
}

bool keeps_tangents(const VelocityStep& form) {
    return form.iteration.solver == Solver::newton_taylor;
}

/// Members that a solver asks for beside forces and positions.
std::string more_text(const Step& step, const VelocityStep& form,
                      const std::vector<std::size_t>& unknown) {
    if (form.iteration.takes_newton()) {
        return newton_of_positions(step, form, unknown, drifts_text());
    }
    return keeps_tangents(form) ? taylor_text(step, unknown) : "";
}

std::string coupled_velocities(const Step& step, const VelocityStep& form) {
    const Block& block = coupled_block(step);
    const std::vector<std::size_t> Q = block.of(Kind::Q);
    // NOTE: a stage may be near 0 where q is not, and moves by what q is rounded to.
    std::string size = "hvi::detail::abs(s.at.q[k]) + hvi::detail::abs(s.free_path[k])";
    for (const std::string_view letter : {"Q", "W"}) {
        for (const std::size_t i : Q) {
            size += fmt::format(" + hvi::detail::abs(s.{}[{}][k])", letter, i);
        }
    }
    return fill_part(
        "coupled_positions.hpp.in",
        {{"unknowns", unknowns(block)},
         {"member", clock_reference(step)},
         {"positions", positions_text(step, form.form, Q)},
         {"forces", forces_text(step, block.of(Kind::Lp))},
         {"size", Writer(2).line("return {};", size).str()},
         {"more", more_text(step, form, Q)},
         {"tangents",
          keeps_tangents(form) ? "hvi::detail::Tangents<System, stages>& tangents;" : ""}});
}

// ---- step() ----

/// sum_j (1 - c_j) W_j.
std::string increment_by_forces(const VelocityForm& form) {
    Increment sum;
    for (std::size_t j = 0; j < form.c.size(); ++j) {
        sum.add(Number(1) - form.c[j], fmt::format("(1 - c[{}])", j),
                fmt::format("s_.W[{}][k]", j));
    }
    return sum.text();
}

void update_q(Writer& writer, const VelocityForm& form) {
    for_components(writer, "s_",
                   [&] { writer.line("s_.end_q(k, {});", increment_by_forces(form)); });
}

/// Returns whether it was the position at the end of the step.
bool evaluate_position(Writer& writer, const Step& step, const VelocityForm& form, std::size_t i) {
    switch (step.positions[i].place) {
    case Place::start: return false;
    case Place::end: update_q(writer, form); return true;
    case Place::inner: break;
    }
    for_components(writer, "s_",
                   [&] { writer.line("s_.Q[{}][k] = {};", i, position(form, i, "s_")); });
    return false;
}

void evaluate_force(Writer& writer, const Step& step, std::size_t i) {
    const bool kept = is_kept(step, {Kind::Lp, i});
    const Place place = step.positions[i].place;
    const std::string at = place == Place::inner ? fmt::format("s_.Q[{}]", i) : "s_.at.q";
    if (!kept || place == Place::end) {
        const SlopePoint point{at, "", time_of_stage(step, std::to_string(i), "s_")};
        writer.line("system_.{};", force_call(step, point, kept ? "force_" : "s_.slope"));
    }
    write_force(writer, i, "s_", "system_", kept ? "force_" : "s_.slope");
}

std::string steps_of_velocities(const Step& step, const VelocityStep& form) {
    Writer writer(2);
    writer.line("s_.weigh(system_, b);").line("s_.drift_freely(system_, c);");
    if (step.kept.force) {
        writer.open("if (!s_.continues) {{")
            .line("hvi::detail::fit(force_, s_.n);")
            .line("system_.{};", force_call(step, start_of_step(step), "force_"))
            .close();
    }
    writer.line("if constexpr (Solver::takes_starting_values) {{ predict(); }}").blank();
    bool q_is_done = false;
    for (const Block& block : step.blocks) {
        const StageNode& node = block.nodes.front();
        if (block.coupled) {
            writer.line("status = solver_.solve(Coupled{{{}s_{}}});", coupled_arguments(step),
                        keeps_tangents(form) ? ", tangents_" : "");
            writer.line("if (!status.ok()) {{ return status; }}");
        } else if (node.kind == Kind::Q) {
            q_is_done = evaluate_position(writer, step, form.form, node.index) || q_is_done;
        } else {
            evaluate_force(writer, step, node.index);
        }
    }
    writer.blank();
    if (!q_is_done) { update_q(writer, form.form); }
    writer.insert(call_of_carry(step));
    writer.line("s_.end_p(system_);");
    return writer.line("return {};", end_of_step(step, "status.iterations")).str();
}

// ---- starting values ----

void extrapolate(Writer& writer, const Extrapolation& from,
                 const std::vector<std::size_t>& unknown) {
    open_extrapolation(writer, from);
    for_components(writer, "s_", [&] {
        recall_slopes(writer, from, "W");
        for (const std::size_t i : unknown) {
            writer.line("s_.W[{}][k] = {};", i, extrapolated(from, i, "W"));
        }
    });
    close_extrapolation(writer, from, {"W"});
}

std::string prediction_of_velocities(const Step& step, const Iteration& iteration) {
    const std::vector<std::size_t> unknown = coupled_block(step).of(Kind::Lp);
    Writer writer(1);
    open_predict(writer, iteration, "forces");
    if (!iteration.extrapolation.empty()) {
        extrapolate(writer, iteration.extrapolation.front(), unknown);
    }
    if (!step.kept.force) {
        writer.line("system_.{};", force_call(step, start_of_step(step), "s_.slope"));
    }
    for (const std::size_t i : unknown) {
        write_force(writer, i, "s_", "system_", step.kept.force ? "force_" : "s_.slope");
    }
    return writer.close().str();
}

// ---- constants, members ----

std::string members_of_velocities(const Step& step, const VelocityStep& form) {
    Writer writer(1);
    writer.line("System system_;").insert(clock_member(step));
    writer.line("hvi::detail::VelocityStages<Vector, stages> s_;");
    writer.line("typename Solver::template Iteration<Vector> solver_;");
    if (keeps_tangents(form)) { writer.line("hvi::detail::Tangents<System, stages> tangents_;"); }
    if (step.kept.force) {
        writer.line("Vector force_{{}};  // dH/dq at s_.at.q, where the last step ended");
    }
    declare_slopes_before(writer, step);
    return writer.str();
}

/// NOTE: one place serves all stages where it is that of the start.
std::string hessian_products(const Step& step) {
    const auto call = [](const std::string& time) {
        return fmt::format("system.d2Hdq2(Q, v{}{}, out);", time.empty() ? "" : ", ", time);
    };
    return Writer(2)
        .comment("d2H/dq2 at Q, times v, at the start of the step, and of stage i.", "/// ")
        .line("void hessian_at_start_times(const Vector& Q, const Vector& v, Vector& out) const {{ "
              "{} }}",
              call(time_of_start(step, "s")))
        .open("void hessian_times([[maybe_unused]] std::size_t i, const Vector& Q, const Vector& "
              "v, Vector& out) const {{")
        .line("{}", call(time_of_stage(step, "i", "s")))
        .close()
        .str();
}

std::string force_at_start(const Step& step) {
    const SlopePoint start{"s.at.q", "", time_of_start(step, "s")};
    return Writer(2)
        .line("void force_at_start(Vector& out) const {{ system.{}; }}",
              force_call(step, start, "out"))
        .str();
}

}  // namespace

std::string newton_of_positions(const Step& step, const VelocityStep& form,
                                const std::vector<std::size_t>& unknown, std::string_view drifts) {
    Writer writer(2);
    writer.line("static constexpr std::array<std::size_t, {}> unknown{{{}}};", unknown.size(),
                fmt::join(unknown, ", "));
    writer.line("static constexpr Scalar coefficient(std::size_t i, std::size_t j) {{ return "
                "n[i][j]; }}");
    writer.insert(modes_text(form.modes, "Modes", "b_i n_ij", 2)).blank();
    writer.comment("W_j = h K Lp_j.", "/// ").open("void drifts() {{");
    writer.insert(drifts).close().blank();
    if (form.hessian != HessianForm::products) { return writer.insert(linearised(step)).str(); }
    writer.insert(force_at_start(step));
    return writer.insert(hessian_products(step)).str();
}

std::string linearised(const Step& step) {
    Writer writer(2);
    writer.insert(force_at_start(step));
    const SlopePoint start{"s.at.q", "", time_of_start(step, "s")};
    writer.line("template <class Matrix>");
    writer.line("void hessian_at_start(Matrix& out) const {{ system.{}; }}",
                hessian_call(start, "out"));
    writer.line("template <class Matrix>");
    writer.line("void hessian(std::size_t i, Matrix& out) const {{ system.{}; }}",
                hessian_call({"s.position(i)", "", time_of_stage(step, "i", "s")}, "out"));
    return writer.str();
}

std::string constants_text(const Step& step, const VelocityStep& velocities,
                           const SceneWishes& wishes) {
    const VelocityForm& form = velocities.form;
    const RoundedVelocityForm& values = velocities.rounded;
    Writer writer(1);
    writer.line("static constexpr std::size_t stages = {};", form.c.size()).blank();
    table(writer, "b", weights(step.positions));
    refuse_float(writer, weights(step.positions));
    std::vector<Constant> c;
    for (std::size_t i = 0; i < form.c.size(); ++i) {
        c.push_back({fmt::format("c_{}", i + 1), values.c[i], exact_text(form.c[i])});
    }
    const char* const n =
        step.momenta.empty() ? "(4.6): n_ij = c_i - A_i G^-1 A_j^T" : "n_ij = sum_k a_ik a~_kj/b_j";
    writer.blank().comment(fmt::format("The momenta are eliminated: {}, rounded with c so that "
                                       "n_ij - n_ji is c_i - c_j exactly.",
                                       n));
    table(writer, "c", c);
    table(writer, "n", constants("n", form.n, values.n));
    writer.line("static_assert(hvi::detail::symplectic(c, n), \"the method is symplectic\");");
    writer.insert(extrapolation_text(velocities.iteration));
    if (wishes.curve) { writer.insert(curve_table(step, *wishes.curve, library(wishes))); }
    writer.insert(gamma_table(step.in_a_row));
    return with_rounding(writer.str());
}

ImplicitParts parts(const Step& step, const VelocityStep& form, const SceneWishes& wishes) {
    ImplicitParts parts;
    parts.runtime = {"detail/stages/velocity_stages"};
    parts.steps = steps_of_velocities(step, form);
    parts.constants = constants_text(step, form, wishes);
    parts.predict = prediction_of_velocities(step, form.iteration);
    parts.coupled = coupled_velocities(step, form);
    parts.members = members_of_velocities(step, form);
    if (wishes.curve) {
        const std::size_t count = step.positions.size();
        parts.curve =
            curve_text(step, *wishes.curve, "s_.free_path[k] + " + increment_by_forces(form.form),
                       slopes_in_rows("W", count), slopes_in_rows("Lp", count));
    }
    return parts;
}

}  // namespace hvi::gen
