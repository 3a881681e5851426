// Stage equations of a curve and the momenta along it.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/steps/clock.hpp"
#include "generator/emit/steps/curve_tables.hpp"
#include "generator/emit/steps/implicit_parts.hpp"
#include "generator/emit/steps/slope_calls.hpp"
#include "generator/emit/steps/starting_values.hpp"

namespace hvi::gen {
namespace {

std::string unknowns(const GalerkinForm& form) {
    Writer writer(1);
    writer.comment(fmt::format("The equations of the {} W_j and the {} P_i, which are solved at "
                               "once.",
                               form.functions(), form.nodes()),
                   "/// ");
    return writer.str();
}

// ---- the coupled stages ----

SlopePoint node(const Step& step) { return {"s.Q[i]", "s.P[i]", time_of_stage(step, "i", "s")}; }

/// Returns the lines that evaluate dH/dq and dH/dp, at once where H is not separable.
std::string slopes(const Step& step, const SlopePoint& at, std::string_view system,
                   std::size_t depth) {
    Writer writer(depth);
    if (step.slopes == Slopes::joint) {
        writer.line("{}.{};", system, gradient_call(at, "dHdq", "dHdp"));
    } else {
        writer.line("{}.{};", system, force_call(step, at, "dHdq"));
        writer.line("{}.{};", system, velocity_call(step, at, "dHdp"));
    }
    return writer.str();
}

/// Returns the lines at the beginning of a sweep. NOTE: Newton's method does not use them.
std::string momenta(const GalerkinStep& form) {
    Writer writer(2);
    if (!takes_fixed_points(form)) { return {}; }
    writer.comment("W_j and Y_i, corrected, and P_i = p + (e_p + Y_i).", "/// ");
    writer.open("void momenta() {{")
        .line("s.correct(X, {}, Z, inverse_G, kinetic);", table_D(form))
        .line("s.momenta();");
    return writer.close().str();
}

std::string newton(const Step& step, const GalerkinStep& form) {
    if (!form.iteration.takes_newton()) { return {}; }
    Writer writer(2);
    writer.insert(tables_for_newton(form));
    const SlopePoint at = node(step);
    writer.line("template <class Matrix>");
    writer.open("void second_derivatives(std::size_t i, Matrix& qq, {}Matrix& qp, Matrix& pp) "
                "const {{",
                step.is_separable() ? "[[maybe_unused]] " : "");
    writer.line("system.{};", hessian_qq_call(step, at, "qq"));
    if (!step.is_separable()) { writer.line("system.{};", hessian_qp_call(at, "qp")); }
    writer.line("system.{};", hessian_pp_call(step, at, "pp"));
    return writer.close().str();
}

std::string members_of_coupled(const Step& step, const GalerkinStep& form) {
    Writer writer(2);
    writer.insert(clock_reference(step));
    writer.insert(choice_of_tables(form));
    if (takes_fixed_points(form)) {
        writer.line("const hvi::detail::FrozenMatrix<Vector>& kinetic;");
    }
    return writer.str();
}

std::string coupled_curve(const Step& step, const GalerkinStep& form) {
    return fill_part("coupled_curve.hpp.in", {{"unknowns", unknowns(form.form)},
                                              {"member", members_of_coupled(step, form)},
                                              {"nodes", std::to_string(form.form.nodes())},
                                              {"functions", std::to_string(form.form.functions())},
                                              {"slopes", slopes(step, node(step), "system", 4)},
                                              {"momenta", momenta(form)},
                                              {"A", std::string(table_A(form))},
                                              {"newton", newton(step, form)}});
}

std::string make_coupled(const Step& step, const GalerkinStep& form) {
    return fmt::format("Coupled{{system_, {}{}{}s_}}", clock_argument(step), adjoint_argument(form),
                       takes_fixed_points(form) ? "kinetic_, " : "");
}

// ---- step() ----

std::string steps_of_curves(const Step& step, const GalerkinStep& form, const SceneWishes& wishes) {
    Writer writer(2);
    writer.line("s_.weigh(b);");
    if (takes_fixed_points(form)) {
        writer.open("const bool is_regular = kinetic_.compute([&](auto& out) {{")
            .line("system_.{};", hessian_pp_call(step, start_of_step(step), "out"))
            .close("});");
        writer.open("if (!is_regular) {{")
            .line("return Status(kinetic_.is_finite() ? Status::Code::singular : "
                  "Status::Code::not_finite);")
            .close();
        writer.line("predict();");
    }
    writer.blank().line("status = solver_.solve({});", make_coupled(step, form));
    writer.line("if (!status.ok()) {{ return status; }}").blank();
    writer.line("s_.advance(B);");
    return writer.insert(end_of_curve(step, wishes)).str();
}

std::string prediction(const Step& step, const GalerkinStep& form) {
    if (!takes_fixed_points(form)) { return {}; }
    Writer writer(1);
    writer.comment(form.extrapolation
                       ? "Starting values: the curve of the last step, and the polynomial through "
                         "its momenta, else the state and its velocity at the start of this one."
                       : "Starting values: the state and its velocity at the start of the step.",
                   "/// ");
    writer.open("void predict() {{");
    if (form.extrapolation) {
        writer.open("if (s_.goes_on) {{").line("s_.extrapolate(N_W, N_P);");
        writer.line("Coupled equations = {};", make_coupled(step, form));
        writer.line("s_.momenta();").line("equations.positions();").line("equations.slopes();");
        writer.line("return;").close();
    }
    writer.line("s_.rest();").line("Vector dHdq, dHdp;");
    writer.insert(slopes(step, start_of_step(step), "system_", 2));
    return writer.line("s_.set_slopes(dHdq, dHdp);").close().str();
}

// ---- constants, members ----

/// Writes the tables of phi and G for the iteration by fixed points.
void write_correction(Writer& writer, const GalerkinForm& form) {
    NumberMatrix Z = form.phi;
    const NumberVector inverse_G = inverses(form.gram);
    for (NumberVector& row : Z) {
        for (std::size_t j = 0; j < row.size(); ++j) { row[j] = row[j] * inverse_G[j]; }
    }
    writer.blank().comment(
        "Z_ij = phi_j(c_i)/G_j, which only says how fast fixed points get there.");
    rough_table(writer, "Z", Z);
    rough_table(writer, "inverse_G", "1/G", inverse_G);
}

std::string constants_of_curves(const Step& step, const GalerkinStep& galerkin,
                                const SceneWishes& wishes) {
    Writer writer(1);
    writer.insert(curve_tables(step, galerkin, wishes));
    if (takes_fixed_points(galerkin)) { write_correction(writer, galerkin.form); }
    if (galerkin.extrapolation) {
        writer.blank().comment("W and P of the next step are about N_W and N_P times those of this "
                               "one.");
        starting_table(writer, "N_W", galerkin.extrapolation->W);
        starting_table(writer, "N_P", *galerkin.extrapolation->P);
    }
    return with_rounding(writer.insert(gamma_table(step.in_a_row)).str());
}

std::string members_of_curves(const Step& step, const GalerkinStep& form) {
    Writer writer(1);
    writer.line("System system_;").insert(clock_member(step)).insert(adjoint_member(form));
    writer.line("hvi::detail::CurveStages<Vector, {}, {}> s_;", form.form.nodes(),
                form.form.functions());
    if (takes_fixed_points(form)) {
        writer.line(
            "hvi::detail::FrozenMatrix<Vector> kinetic_;  // d2H/dp2 where the step begins");
    }
    return writer.line("typename Solver::template Iteration<Vector> solver_;").str();
}

}  // namespace

ImplicitParts parts(const Step& step, const GalerkinStep& form, const SceneWishes& wishes) {
    if (form.side == Side::lagrangian) { return lagrangian_parts(step, form, wishes); }
    ImplicitParts parts;
    parts.runtime = {"detail/coefficients/curve_coefficients", "detail/stages/curve_stages"};
    if (takes_fixed_points(form)) { parts.runtime.emplace_back("detail/linear/frozen_matrix"); }
    parts.steps = steps_of_curves(step, form, wishes);
    parts.constants = constants_of_curves(step, form, wishes);
    parts.predict = prediction(step, form);
    parts.coupled = coupled_curve(step, form);
    parts.members = members_of_curves(step, form);
    add_position(parts, step, form, wishes);
    if (wishes.action) { add_action(parts, step, form); }
    return parts;
}

}  // namespace hvi::gen
