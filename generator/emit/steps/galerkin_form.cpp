// Stage equations of a curve and the momenta along it.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/steps/clock.hpp"
#include "generator/emit/steps/implicit_parts.hpp"
#include "generator/emit/steps/slope_calls.hpp"
#include "generator/emit/steps/starting_values.hpp"

namespace hvi::gen {
namespace {

bool takes_fixed_points(const GalerkinStep& form) {
    return form.iteration.solver != Solver::newton;
}

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

/// dH/dq and dH/dp at once where H is not separable.
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

/// What begins a sweep. NOTE: Newton's method has no use for it.
std::string momenta(const GalerkinStep& form) {
    Writer writer(2);
    if (!takes_fixed_points(form)) { return {}; }
    writer.comment("W_j and Y_i, corrected, and P_i = p + (e_p + Y_i).", "/// ");
    writer.open("void momenta() {{")
        .line("s.correct(X, D, Z, inverse_G, kinetic);")
        .line("s.momenta();");
    return writer.close().str();
}

std::string newton(const Step& step, const GalerkinStep& form) {
    if (!form.iteration.takes_newton()) { return {}; }
    Writer writer(2);
    for (const std::string_view table : {"X", "A", "D"}) {
        writer.line("static constexpr const auto& table_{0}() {{ return {0}; }}", table);
    }
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
                                              {"newton", newton(step, form)}});
}

std::string make_coupled(const Step& step, const GalerkinStep& form) {
    return fmt::format("Coupled{{system_, {}{}s_}}", clock_argument(step),
                       takes_fixed_points(form) ? "kinetic_, " : "");
}

// ---- step() ----

std::string steps_of_curves(const Step& step, const GalerkinStep& form) {
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
    return writer.line("return {};", end_of_step(step, "status.iterations")).str();
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
        writer.open("if (s_.h == s_.h_before) {{").line("s_.extrapolate(N_W, N_P);");
        writer.line("Coupled equations = {};", make_coupled(step, form));
        writer.line("s_.momenta();").line("equations.positions();").line("equations.slopes();");
        writer.line("return;").close();
    }
    writer.line("s_.rest();").line("Vector dHdq, dHdp;");
    writer.insert(slopes(step, start_of_step(step), "system_", 2));
    return writer.line("s_.set_slopes(dHdq, dHdp);").close().str();
}

// ---- constants, members ----

/// Rounded on its own: for starting values, and for the way to a solution.
void rough_table(Writer& writer, std::string_view name, const NumberMatrix& exact) {
    RoundedMatrix values;
    for (const NumberVector& row : exact) {
        auto& rounded = values.emplace_back();
        for (const Number& entry : row) { rounded.push_back(nearest_or_small(entry)); }
    }
    table(writer, name, constants(name, exact, values));
}

std::vector<Constant> column(std::string_view name, const NumberVector& exact,
                             const std::vector<Rounded>& values) {
    std::vector<Constant> result;
    for (std::size_t j = 0; j < exact.size(); ++j) {
        result.push_back({fmt::format("{}_{}", name, j + 1), values[j], exact_text(exact[j])});
    }
    return result;
}

std::vector<Constant> column(std::string_view name, const NumberVector& exact) {
    std::vector<Rounded> values;
    for (const Number& entry : exact) { values.push_back(nearest_or_small(entry)); }
    return column(name, exact, values);
}

/// What the iteration by fixed points takes, of phi and G.
void write_correction(Writer& writer, const GalerkinForm& form) {
    NumberMatrix Z = form.phi;
    NumberVector inverse_G;
    for (std::size_t j = 0; j < form.functions(); ++j) {
        inverse_G.push_back(Number(1) / form.gram[j]);
        for (NumberVector& row : Z) { row[j] = row[j] * inverse_G[j]; }
    }
    writer.blank().comment(
        "Z_ij = phi_j(c_i)/G_j, which only says how fast fixed points get there.");
    rough_table(writer, "Z", Z);
    table(writer, "inverse_G", column("1/G", inverse_G));
}

NumberMatrix weighted(const GalerkinForm& form) {
    NumberMatrix X = form.phi;
    for (std::size_t i = 0; i < form.nodes(); ++i) {
        for (Number& entry : X[i]) { entry = form.b[i] * entry; }
    }
    return X;
}

NumberMatrix remaining(const GalerkinForm& form) {
    NumberMatrix D = form.A;
    for (NumberVector& row : D) {
        for (std::size_t j = 0; j < row.size(); ++j) { row[j] = form.B[j] - row[j]; }
    }
    return D;
}

std::string constants_of_curves(const Step& step, const GalerkinStep& galerkin) {
    const GalerkinForm& form = galerkin.form;
    const RoundedGalerkinForm& values = galerkin.rounded;
    Writer writer(1);
    table(writer, "b", weights(step.positions));
    refuse_float(writer, weights(step.positions));
    if (const std::string times = times_text(step); !times.empty()) { writer.insert(times); }
    writer.blank().comment("(4.6) in a basis phi that is orthogonal for the rule: X_ij = b_i "
                           "phi_j(c_i), A_ij and B_j are its integrals to c_i and to 1, and D_ij = "
                           "B_j - A_ij, rounded so that this holds exactly, and B_j is the sum of "
                           "the X_ij.");
    table(writer, "X", constants("X", weighted(form), values.X));
    table(writer, "A", constants("A", form.A, values.A));
    table(writer, "D", constants("D", remaining(form), values.D));
    table(writer, "B", column("B", form.B, values.B));
    writer.line("static_assert(hvi::detail::symplectic_curve(X, A, D, B), \"the method is "
                "symplectic\");");
    if (takes_fixed_points(galerkin)) { write_correction(writer, form); }
    if (galerkin.extrapolation) {
        writer.blank().comment("W and P of the next step are about N_W and N_P times those of this "
                               "one.");
        rough_table(writer, "N_W", galerkin.extrapolation->W);
        rough_table(writer, "N_P", galerkin.extrapolation->P);
    }
    if (!galerkin.steps.empty()) {
        writer.blank().comment("A step is steps of these parts of h.");
        table(writer, "gamma", column("gamma", galerkin.steps));
    }
    return with_rounding(writer.str());
}

std::string members_of_curves(const Step& step, const GalerkinStep& form) {
    Writer writer(1);
    writer.line("System system_;").insert(clock_member(step));
    writer.line("hvi::detail::CurveStages<Vector, {}, {}> s_;", form.form.nodes(),
                form.form.functions());
    if (takes_fixed_points(form)) {
        writer.line(
            "hvi::detail::FrozenMatrix<Vector> kinetic_;  // d2H/dp2 where the step begins");
    }
    return writer.line("typename Solver::template Iteration<Vector> solver_;").str();
}

}  // namespace

ImplicitParts parts(const Step& step, const GalerkinStep& form, const SceneWishes&) {
    ImplicitParts parts;
    parts.runtime = {"detail/coefficients/curve_coefficients", "detail/stages/curve_stages"};
    if (takes_fixed_points(form)) { parts.runtime.emplace_back("detail/linear/frozen_matrix"); }
    parts.steps = steps_of_curves(step, form);
    parts.constants = constants_of_curves(step, form);
    parts.predict = prediction(step, form);
    parts.coupled = coupled_curve(step, form);
    parts.members = members_of_curves(step, form);
    parts.composes = !form.steps.empty();
    return parts;
}

}  // namespace hvi::gen
