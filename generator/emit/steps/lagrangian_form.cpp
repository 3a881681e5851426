// Stage equations (4.14): the velocities of a curve.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>

#include "generator/emit/steps/clock.hpp"
#include "generator/emit/steps/curve_tables.hpp"
#include "generator/emit/steps/implicit_parts.hpp"
#include "generator/emit/steps/starting_values.hpp"

namespace hvi::gen {
namespace {

/// Returns `, clock.t[i]`, where L depends on the time.
std::string also(const std::string& time) { return time.empty() ? "" : ", " + time; }

// ---- the coupled stages ----

std::string members_of_coupled_lagrangian(const Step& step, const GalerkinStep& form) {
    Writer writer(2);
    writer.insert(clock_reference(step));
    writer.insert(choice_of_tables(form));
    if (takes_fixed_points(form)) { writer.line("const hvi::detail::FrozenMatrix<Vector>& mass;"); }
    return writer.str();
}

std::string correction(const GalerkinStep& form) {
    if (!takes_fixed_points(form)) { return {}; }
    Writer writer(2);
    writer.comment("P_i, and W_j corrected.", "/// ");
    writer.open("void momenta() {{").line("s.momenta();");
    writer.line("s.correct(X, {}, inverse_G, mass);", table_D(form)).close();
    return writer.str();
}

std::string newton_of_lagrangian(const Step& step, const GalerkinStep& form) {
    if (!form.iteration.takes_newton()) { return {}; }
    Writer writer(2);
    writer.insert(tables_for_newton(form));
    writer.line("template <class Matrix>");
    writer.open(
        "void second_derivatives(std::size_t i, Matrix& qq, Matrix& qv, Matrix& vv) const {{");
    writer.line("const Vector U = s.velocity(i, X);");
    const std::string time = also(time_of_stage(step, "i", "s"));
    writer.line("system.d2Ldq2(s.Q[i], U{}, qq);", time);
    writer.line("system.d2Ldqdv(s.Q[i], U{}, qv);", time);
    writer.line("system.d2Ldv2(s.Q[i], U{}, vv);", time);
    return writer.close().str();
}

std::string coupled_lagrangian(const Step& step, const GalerkinStep& form) {
    return fill_part("coupled_lagrangian.hpp.in",
                     {{"member", members_of_coupled_lagrangian(step, form)},
                      {"nodes", std::to_string(form.form.nodes())},
                      {"functions", std::to_string(form.form.functions())},
                      {"time", also(time_of_stage(step, "i", "s"))},
                      {"correction", correction(form)},
                      {"A", std::string(table_A(form))},
                      {"newton", newton_of_lagrangian(step, form)}});
}

// ---- step() ----

std::string steps_of_lagrangian(const Step& step, const GalerkinStep& form,
                                const SceneWishes& wishes) {
    Writer writer(2);
    writer.line("s_.weigh(b);");
    if (takes_fixed_points(form)) {
        writer.line("status = predict();");
        writer.line("if (!status.ok()) {{ return status; }}").blank();
    }
    writer.line("status = solver_.solve(Coupled{{system_, {}{}{}s_}});", clock_argument(step),
                adjoint_argument(form), takes_fixed_points(form) ? "mass_, " : "");
    writer.line("if (!status.ok()) {{ return status; }}").blank();
    writer.line("s_.advance(B);");
    return writer.insert(end_of_curve(step, wishes)).str();
}

/// Returns the node nearest to the middle of the step.
std::size_t middle(const GalerkinForm& form) {
    const auto distance = [&](std::size_t i) { return std::abs(form.c[i].nearest_double() - 0.5); };
    std::size_t found = 0;
    for (std::size_t i = 1; i < form.nodes(); ++i) {
        if (distance(i) < distance(found)) { found = i; }
    }
    return found;
}

/// Writes the lines that set the matrix of fixed points. NOTE: it does not depend on v, so that any
/// v will do.
void write_mass(Writer& writer, const Step& step) {
    const bool has_time = step.depends_on_time();
    writer.comment("Takes d2L/dv2 there for the iteration.", "/// ");
    writer.open("[[nodiscard]] Status freeze(const Vector& q{}) {{", has_time ? ", Scalar t" : "");
    writer.line("const auto fill = [&](auto& out) {{ system_.d2Ldv2(q, s_.at.p{}, out); }};",
                has_time ? ", t" : "");
    writer.line("if (mass_.compute(fill)) {{ return {{}}; }}");
    writer.line("return Status(mass_.is_finite() ? Status::Code::singular : "
                "Status::Code::not_finite);");
    writer.close().blank();
}

/// Returns the prediction of a step. NOTE: it sets positions and slopes too, as a sweep begins with
/// the correction. Where d2L/dv2 varies, taking it in the middle of the step in place of its start
/// saves a tenth to a fifth of the sweeps.
std::string prediction_of_lagrangian(const Step& step, const GalerkinStep& form) {
    if (!takes_fixed_points(form)) { return {}; }
    const std::string time = also(time_of_start(step, "s_"));
    Writer writer(1);
    write_mass(writer, step);
    writer.comment(form.extrapolation
                       ? "Starting values: the curve of the last step goes on, else straight."
                       : "Starting values: the curve goes straight.",
                   "/// ");
    writer.open("[[nodiscard]] Status predict() {{");
    if (form.extrapolation) {
        writer.line("if (s_.goes_on) {{ s_.extrapolate(N_W); }}");
        writer.open("if (!s_.goes_on) {{");
    }
    writer.line("const Status start = freeze(s_.at.q{});", time);
    writer.line("if (!start.ok()) {{ return start; }}");
    writer.line("const Vector v = hvi::detail::velocity_of(system_, mass_, s_.at.q, s_.at.p{});",
                time);
    writer.line("s_.go_straight(v, B, inverse_G);");
    if (form.extrapolation) { writer.close(); }
    writer.line("Coupled equations{{system_, {}{}mass_, s_}};", clock_argument(step),
                adjoint_argument(form));
    writer.line("equations.positions();");
    const std::string node = std::to_string(middle(form.form));
    writer.line("const Status status = freeze(s_.Q[{}]{});", node,
                also(time_of_stage(step, node, "s_")));
    writer.line("if (status.ok()) {{ equations.slopes(); }}");
    return writer.line("return status;").close().str();
}

// ---- constants, members ----

std::string constants_of_lagrangian(const Step& step, const GalerkinStep& galerkin,
                                    const SceneWishes& wishes) {
    Writer writer(1);
    writer.insert(curve_tables(step, galerkin, wishes));
    if (takes_fixed_points(galerkin)) {
        writer.blank().comment("G_j is the sum of b_i phi_j(c_i)^2 over i.");
        rough_table(writer, "inverse_G", "1/G", inverses(galerkin.form.gram));
    }
    if (galerkin.extrapolation && takes_fixed_points(galerkin)) {
        writer.blank().comment("W of the next step is about N_W times that of this one.");
        starting_table(writer, "N_W", galerkin.extrapolation->W);
    }
    return with_rounding(writer.insert(gamma_table(step.in_a_row)).str());
}

std::string members_of_lagrangian(const Step& step, const GalerkinStep& form) {
    Writer writer(1);
    writer.line("System system_;").insert(clock_member(step)).insert(adjoint_member(form));
    writer.line("hvi::detail::LagrangianStages<Vector, {}, {}> s_;", form.form.nodes(),
                form.form.functions());
    if (takes_fixed_points(form)) {
        writer.line(
            "hvi::detail::FrozenMatrix<Vector> mass_;  // d2L/dv2 in the middle of the step");
    }
    return writer.line("typename Solver::template Iteration<Vector> solver_;").str();
}

}  // namespace

ImplicitParts lagrangian_parts(const Step& step, const GalerkinStep& form,
                               const SceneWishes& wishes) {
    ImplicitParts parts;
    parts.runtime = {"detail/coefficients/curve_coefficients", "detail/stages/lagrangian_stages"};
    parts.steps = steps_of_lagrangian(step, form, wishes);
    parts.constants = constants_of_lagrangian(step, form, wishes);
    parts.predict = prediction_of_lagrangian(step, form);
    parts.coupled = coupled_lagrangian(step, form);
    parts.members = members_of_lagrangian(step, form);
    add_position(parts, step, form, wishes);
    if (wishes.action) { add_action(parts, step, form); }
    return parts;
}

}  // namespace hvi::gen
