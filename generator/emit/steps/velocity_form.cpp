// Stage equations of positions alone.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/steps/implicit_parts.hpp"
#include "generator/emit/steps/starting_values.hpp"
#include "generator/plan/equal.hpp"
#include "generator/plan/lattice.hpp"
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

/// factor * what, where a factor of 1 and a term of 0 leave no trace.
void add_term(std::string& sum, const Number& value, std::string_view factor,
              std::string_view what) {
    if (equal(value, 0)) { return; }
    if (!sum.empty()) { sum += " + "; }
    sum += equal(value, 1) ? std::string(what) : fmt::format("{} * {}", factor, what);
}

/// h c_i v + sum_j n_ij W_j, of `hv` = h v.
std::string increment(const VelocityForm& form, std::size_t i, std::string_view s) {
    std::string sum;
    add_term(sum, form.c[i], fmt::format("c[{}]", i), "hv");
    for (std::size_t j = 0; j < form.c.size(); ++j) {
        add_term(sum, form.n[i][j], fmt::format("n[{}][{}]", i, j),
                 fmt::format("{}.W[{}][k]", s, j));
    }
    return sum;
}

// ---- the coupled stages ----

const Block& coupled_block(const Scheme& scheme) {
    for (const Block& block : scheme.blocks) {
        if (block.coupled) { return block; }
    }
    HVI_CHECK(false);
    return scheme.blocks.front();
}

std::string positions_text(const VelocityForm& form, const std::vector<std::size_t>& Q) {
    Writer writer(2);
    for_components(writer, "s", [&] {
        writer.line("const Scalar q = s.at.q[k];");
        writer.line("const Scalar e_q = s.remainder.q[k];");
        writer.line("const Scalar hv = s.h * s.velocity[k];");
        std::string change;
        for (const std::size_t i : Q) {
            writer.line("const Scalar Q_{} = q + (e_q + ({}));", i + 1, increment(form, i, "s"));
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
    writer.line("{1}.inverse_mass({0}.Lp[{2}], {0}.W[{2}]);", s, system, i);
    for_components(writer, s, [&] { writer.line("{0}.W[{1}][k] *= {0}.h;", s, i); });
}

/// Lp_i and W_i from `slope`, which is dH/dq there.
void write_force(Writer& writer, std::size_t i, std::string_view s, std::string_view system,
                 std::string_view slope) {
    for_components(writer, s,
                   [&] { writer.line("{0}.Lp[{1}][k] = -{0}.hb[{1}] * {2}[k];", s, i, slope); });
    write_velocity(writer, std::to_string(i), s, system);
}

std::string forces_text(const Scheme& scheme, const std::vector<std::size_t>& Lp) {
    Writer writer(2);
    writer.line("auto&& slope = hvi::detail::scratch(s.slope);");
    for (const std::size_t i : Lp) {
        writer.line("system.dHdq(s.Q[{}], {}slope);", i, stage_time(scheme, i, "s"));
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
std::string taylor_text(const Scheme& scheme, const std::vector<std::size_t>& unknown) {
    Writer writer(2);
    const std::string time = scheme.depends_on_time ? "clock.t[j], " : "";
    writer.line("static constexpr std::array<std::size_t, {}> unknown{{{}}};", unknown.size(),
                fmt::join(unknown, ", "));
    writer.blank().comment("The same, with the tangents of dH/dq at Q.", "/// ");
    writer.open("void forces_and_tangents() {{");
    writer.line("auto&& slope = hvi::detail::scratch(s.slope);");
    writer.open("for (const std::size_t j : unknown) {{");
    writer.line("system.dHdq(s.Q[j], {}slope, tangents.at[j]);", time);
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

/// What a solver asks for beside forces and positions.
std::string more_text(const Scheme& scheme, const std::vector<std::size_t>& unknown) {
    if (scheme.takes_newton()) { return newton_of_positions(scheme, unknown, drifts_text()); }
    return scheme.solver == Solver::newton_taylor ? taylor_text(scheme, unknown) : "";
}

std::string coupled_velocities(const Scheme& scheme) {
    const Block& block = coupled_block(scheme);
    const std::vector<std::size_t> Q = block.of(Kind::Q);
    // NOTE: a stage may be near 0 where q is not, and moves by what q is rounded to.
    std::string size = "hvi::detail::abs(s.at.q[k]) + hvi::detail::abs(s.h * s.velocity[k])";
    for (const std::string_view letter : {"Q", "W"}) {
        for (const std::size_t i : Q) {
            size += fmt::format(" + hvi::detail::abs(s.{}[{}][k])", letter, i);
        }
    }
    return fill_part(
        "coupled_positions.hpp.in",
        {{"unknowns", unknowns(block)},
         {"member",
          scheme.depends_on_time ? fmt::format("const {}& clock;", clock_type(scheme)) : ""},
         {"positions", positions_text(*scheme.velocity_form, Q)},
         {"forces", forces_text(scheme, block.of(Kind::Lp))},
         {"size", Writer(2).line("return {};", size).str()},
         {"more", more_text(scheme, Q)},
         {"tangents", scheme.solver == Solver::newton_taylor
                          ? "hvi::detail::Tangents<System, stages>& tangents;"
                          : ""}});
}

// ---- step() ----

/// h v + sum_j (1 - c_j) W_j.
std::string increment_of_step(const VelocityForm& form) {
    std::string sum = "s_.h * s_.velocity[k]";
    for (std::size_t j = 0; j < form.c.size(); ++j) {
        add_term(sum, Number(1) - form.c[j], fmt::format("(1 - c[{}])", j),
                 fmt::format("s_.W[{}][k]", j));
    }
    return sum;
}

void update_q(Writer& writer, const VelocityForm& form) {
    for_components(writer, "s_", [&] {
        writer.line("s_.add(s_.at.q[k], s_.remainder.q[k], {});", increment_of_step(form));
    });
}

void update_p(Writer& writer, std::size_t stages) {
    std::string sum;
    for (std::size_t j = 0; j < stages; ++j) {
        sum += fmt::format("{}s_.Lp[{}][k]", j == 0 ? "" : " + ", j);
    }
    for_components(writer, "s_",
                   [&] { writer.line("s_.add(s_.at.p[k], s_.remainder.p[k], {});", sum); });
}

/// Returns whether it was the position at the end of the step.
bool evaluate_position(Writer& writer, const Scheme& scheme, std::size_t i) {
    switch (scheme.positions[i].place) {
    case Place::start: return false;
    case Place::end: update_q(writer, *scheme.velocity_form); return true;
    case Place::inner: break;
    }
    for_components(writer, "s_", [&] {
        writer.line("const Scalar hv = s_.h * s_.velocity[k];");
        writer.line("s_.Q[{}][k] = s_.at.q[k] + (s_.remainder.q[k] + ({}));", i,
                    increment(*scheme.velocity_form, i, "s_"));
    });
    return false;
}

void evaluate_force(Writer& writer, const Scheme& scheme, std::size_t i) {
    const bool kept = is_kept(scheme, {Kind::Lp, i});
    const Place place = scheme.positions[i].place;
    const std::string at = place == Place::inner ? fmt::format("s_.Q[{}]", i) : "s_.at.q";
    if (!kept || place == Place::end) {
        writer.line("system_.dHdq({}, {}{});", at, stage_time(scheme, i, "s_"),
                    kept ? "force_" : "s_.slope");
    }
    write_force(writer, i, "s_", "system_", kept ? "force_" : "s_.slope");
}

std::string steps_of_velocities(const Scheme& scheme) {
    Writer writer(2);
    writer.line("s_.weigh(b);").line("system_.dHdp(s_.at.p, s_.velocity);");
    if (scheme.keeps_force) {
        writer.open("if (!s_.continues) {{")
            .line("hvi::detail::fit(force_, s_.n);")
            .line("system_.dHdq(s_.at.q, {}force_);", start_time(scheme))
            .close();
    }
    writer.line("if constexpr (Solver::takes_starting_values) {{ predict(); }}").blank();
    bool q_is_done = false;
    for (const Block& block : scheme.blocks) {
        const StageNode& node = block.nodes.front();
        if (block.coupled) {
            writer.line("status = solver_.solve(Coupled{{{}s_{}}});", coupled_arguments(scheme),
                        scheme.solver == Solver::newton_taylor ? ", tangents_" : "");
            writer.line("if (!status.ok()) {{ return status; }}");
        } else if (node.kind == Kind::Q) {
            q_is_done = evaluate_position(writer, scheme, node.index) || q_is_done;
        } else {
            evaluate_force(writer, scheme, node.index);
        }
    }
    writer.blank();
    if (!q_is_done) { update_q(writer, *scheme.velocity_form); }
    update_p(writer, scheme.positions.size());
    return writer.line("return {};", end_of_step(scheme, "status.iterations")).str();
}

// ---- starting values ----

void extrapolate(Writer& writer, const Scheme& scheme, const std::vector<std::size_t>& unknown) {
    open_extrapolation(writer, scheme);
    for_components(writer, "s_", [&] {
        recall_slopes(writer, scheme, "W");
        for (const std::size_t i : unknown) {
            writer.line("s_.W[{}][k] = {};", i, extrapolated(scheme, i, "W"));
        }
    });
    close_extrapolation(writer, scheme);
}

std::string prediction_of_velocities(const Scheme& scheme) {
    const std::vector<std::size_t> unknown = coupled_block(scheme).of(Kind::Lp);
    Writer writer(1);
    open_predict(writer, scheme, "forces");
    if (scheme.extrapolation) { extrapolate(writer, scheme, unknown); }
    if (!scheme.keeps_force) {
        writer.line("system_.dHdq(s_.at.q, {}s_.slope);", start_time(scheme));
    }
    for (const std::size_t i : unknown) {
        write_force(writer, i, "s_", "system_", scheme.keeps_force ? "force_" : "s_.slope");
    }
    return writer.close().str();
}

// ---- constants, members ----

std::string members_of_velocities(const Scheme& scheme) {
    Writer writer(1);
    writer.line("System system_;");
    if (scheme.depends_on_time) { writer.line("{} clock_;", clock_type(scheme)); }
    writer.line("hvi::detail::VelocityStages<Vector, stages> s_;");
    writer.line("typename Solver::template Iteration<Vector> solver_;");
    if (scheme.solver == Solver::newton_taylor) {
        writer.line("hvi::detail::Tangents<System, stages> tangents_;");
    }
    if (scheme.keeps_force) {
        writer.line("Vector force_{{}};  // dH/dq at s_.at.q, where the last step ended");
    }
    declare_slopes_before(writer, scheme);
    return writer.str();
}

}  // namespace

std::string newton_of_positions(const Scheme& scheme, const std::vector<std::size_t>& unknown,
                                std::string_view drifts) {
    Writer writer(2);
    writer.line("static constexpr std::array<std::size_t, {}> unknown{{{}}};", unknown.size(),
                fmt::join(unknown, ", "));
    writer.line("static constexpr Scalar coefficient(std::size_t i, std::size_t j) {{ return "
                "n[i][j]; }}");
    writer.insert(modes_text(scheme)).blank();
    writer.comment("W_j = h K Lp_j.", "/// ").open("void drifts() {{");
    writer.insert(drifts).close().blank();
    const std::string_view start = scheme.depends_on_time ? "clock.start, " : "";
    writer.line("void force_at_start(Vector& out) const {{ system.dHdq(s.at.q, {}out); }}", start);
    writer.line("template <class Matrix>");
    writer.line("void hessian_at_start(Matrix& out) const {{ system.d2Hdq2(s.at.q, {}out); }}",
                start);
    writer.line("template <class Matrix>");
    writer.line("void hessian(std::size_t i, Matrix& out) const {{ system.d2Hdq2(s.position(i), "
                "{}out); }}",
                scheme.depends_on_time ? "clock.t[i], " : "");
    return writer.str();
}

std::string velocity_constants(const Scheme& scheme, const SceneWishes& wishes) {
    const VelocityForm& form = *scheme.velocity_form;
    const RoundedVelocityForm values = rounded(form);
    Writer writer(1);
    writer.line("static constexpr std::size_t stages = {};", form.c.size()).blank();
    table(writer, "b", weights(scheme.positions));
    refuse_float(writer, weights(scheme.positions));
    std::vector<Constant> c;
    for (std::size_t i = 0; i < form.c.size(); ++i) {
        c.push_back({fmt::format("c_{}", i + 1), values.c[i], exact_text(form.c[i])});
    }
    writer.blank().comment("The momenta are eliminated: n_ij = sum_k a_ik a~_kj/b_j, rounded with "
                           "c so that n_ij - n_ji is c_i - c_j exactly.");
    table(writer, "c", c);
    table(writer, "n", constants("n", form.n, values.n));
    writer.line("static_assert(hvi::detail::symplectic(c, n), \"the method is symplectic\");");
    if (scheme.extrapolation) { writer.blank().insert(extrapolation_text(scheme)); }
    if (wishes.curve) { writer.insert(curve_table(scheme, *wishes.curve, library(wishes))); }
    return with_rounding(writer.str());
}

ImplicitParts velocity_parts(const Scheme& scheme, const SceneWishes& wishes) {
    HVI_CHECK(scheme.velocity_form && scheme.coupled_blocks() == 1);
    ImplicitParts parts;
    parts.runtime = {"detail/stages/velocity_stages"};
    parts.steps = steps_of_velocities(scheme);
    parts.constants = velocity_constants(scheme, wishes);
    parts.predict = prediction_of_velocities(scheme);
    parts.coupled = coupled_velocities(scheme);
    parts.members = members_of_velocities(scheme);
    if (wishes.curve) {
        parts.curve = curve_text(scheme, *wishes.curve, increment_of_step(*scheme.velocity_form),
                                 [](std::size_t i) { return fmt::format("s_.W[{}][k]", i); });
    }
    return parts;
}

}  // namespace hvi::gen
