// Stage equations (4.14): the velocities of a curve.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/steps/clock.hpp"
#include "generator/emit/steps/curve_tables.hpp"
#include "generator/emit/steps/implicit_parts.hpp"

namespace hvi::gen {
namespace {

/// `, clock.t[i]`, where L depends on the time.
std::string also(const std::string& time) { return time.empty() ? "" : ", " + time; }

// ---- the coupled stages ----

std::string members_of_coupled_lagrangian(const Step& step, const GalerkinStep& form) {
    Writer writer(2);
    writer.insert(clock_reference(step));
    if (takes_fixed_points(form)) { writer.line("const hvi::detail::FrozenMatrix<Vector>& mass;"); }
    return writer.str();
}

std::string correction(const GalerkinStep& form) {
    if (!takes_fixed_points(form)) { return {}; }
    Writer writer(2);
    writer.comment("W_j, corrected.", "/// ");
    writer.line("void momenta() {{ s.correct(X, D, inverse_G, mass); }}");
    return writer.str();
}

std::string newton_of_lagrangian(const Step& step, const GalerkinStep& form) {
    if (!form.iteration.takes_newton()) { return {}; }
    Writer writer(2);
    for (const std::string_view table : {"X", "A", "D"}) {
        writer.line("static constexpr const auto& table_{0}() {{ return {0}; }}", table);
    }
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
                      {"newton", newton_of_lagrangian(step, form)}});
}

// ---- step() ----

std::string steps_of_lagrangian(const Step& step, const GalerkinStep& form,
                                const SceneWishes& wishes) {
    const std::string time = also(time_of_start(step, "s_"));
    Writer writer(2);
    writer.line("s_.weigh(b);");
    if (takes_fixed_points(form)) {
        writer.open("const bool is_regular = mass_.compute([&](auto& out) {{")
            .line("system_.d2Ldv2(s_.at.q, s_.at.p{}, out);", time)
            .close("});");
        writer.open("if (!is_regular) {{")
            .line("return Status(mass_.is_finite() ? Status::Code::singular : "
                  "Status::Code::not_finite);")
            .close();
        writer.line("predict();").blank();
    }
    writer.line("status = solver_.solve(Coupled{{system_, {}{}s_}});", clock_argument(step),
                takes_fixed_points(form) ? "mass_, " : "");
    writer.line("if (!status.ok()) {{ return status; }}").blank();
    writer.line("s_.advance(B);");
    return writer.insert(end_of_curve(step, form, wishes)).str();
}

/// NOTE: positions and slopes too, as a sweep begins with the correction.
std::string prediction_of_lagrangian(const Step& step, const GalerkinStep& form) {
    if (!takes_fixed_points(form)) { return {}; }
    Writer writer(1);
    writer.comment(form.extrapolation
                       ? "Starting values: the curve of the last step goes on, else straight."
                       : "Starting values: the curve goes straight.",
                   "/// ");
    writer.open("void predict() {{");
    const std::string straight =
        fmt::format("s_.go_straight(hvi::detail::velocity_of(system_, mass_, s_.at.q, s_.at.p{}), "
                    "B, inverse_G);",
                    also(time_of_start(step, "s_")));
    if (form.extrapolation) {
        writer.line("const bool goes_on = s_.h == s_.h_before;");
        writer.line("if (goes_on) {{ s_.extrapolate(N_W); }}");
        writer.line("if (!goes_on) {{ {} }}", straight);
    } else {
        writer.line("{}", straight);
    }
    writer.line("Coupled equations{{system_, {}mass_, s_}};", clock_argument(step));
    writer.line("equations.positions();").line("equations.slopes();");
    return writer.close().str();
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
        rough_table(writer, "N_W", galerkin.extrapolation->W);
    }
    return with_rounding(writer.insert(gamma_table(galerkin)).str());
}

std::string members_of_lagrangian(const Step& step, const GalerkinStep& form) {
    Writer writer(1);
    writer.line("System system_;").insert(clock_member(step));
    writer.line("hvi::detail::LagrangianStages<Vector, {}, {}> s_;", form.form.nodes(),
                form.form.functions());
    if (takes_fixed_points(form)) {
        writer.line("hvi::detail::FrozenMatrix<Vector> mass_;  // d2L/dv2 where the step begins");
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
    parts.composes = !form.steps.empty();
    add_position(parts, form, wishes);
    if (wishes.action) { add_action(parts, step, form); }
    return parts;
}

}  // namespace hvi::gen
