// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/steps/curve_tables.hpp"

#include "generator/emit/steps/clock.hpp"
#include "generator/emit/steps/implicit_parts.hpp"
#include "generator/ir/equal.hpp"

namespace hvi::gen {
namespace {

std::vector<Constant> column(std::string_view name, const NumberVector& exact,
                             const std::vector<Rounded>& values) {
    std::vector<Constant> result;
    for (std::size_t j = 0; j < exact.size(); ++j) {
        result.push_back({fmt::format("{}_{}", name, j + 1), values[j], exact_text(exact[j])});
    }
    return result;
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

}  // namespace

std::string curve_tables(const Step& step, const GalerkinForm& form,
                         const RoundedGalerkinForm& values, std::string_view equation) {
    Writer writer(1);
    table(writer, "b", weights(step.positions));
    refuse_float(writer, weights(step.positions));
    if (const std::string times = times_text(step); !times.empty()) { writer.insert(times); }
    writer.blank().comment(
        fmt::format("{} in a basis phi that is orthogonal for the rule: X_ij = b_i phi_j(c_i), "
                    "A_ij and B_j are its integrals to c_i and to 1, and D_ij = B_j - A_ij, "
                    "rounded so that this holds exactly, and B_j is the sum of the X_ij.",
                    equation));
    table(writer, "X", constants("X", weighted(form), values.X));
    table(writer, "A", constants("A", form.A, values.A));
    table(writer, "D", constants("D", remaining(form), values.D));
    table(writer, "B", column("B", form.B, values.B));
    writer.line("static_assert(hvi::detail::symplectic_curve(X, A, D, B), \"the method is "
                "symplectic\");");
    return writer.str();
}

std::string curve_tables(const Step& step, const GalerkinStep& form, const SceneWishes& wishes) {
    Writer writer(1);
    writer.insert(curve_tables(step, form.form, form.rounded,
                               form.side == Side::hamiltonian ? "(4.6)" : "(4.14)"));
    if (wishes.curve) { writer.insert(curve_table(step, *wishes.curve, library(wishes))); }
    return writer.str();
}

void add_position(ImplicitParts& parts, const Step& step, const GalerkinStep& form,
                  const SceneWishes& wishes) {
    if (!wishes.curve) { return; }
    const std::vector<std::string> W = slopes_in_rows("W", form.form.functions());
    std::string chord;
    for (std::size_t j = 0; j < W.size(); ++j) {
        chord += fmt::format("{}B[{}] * {}", j == 0 ? "" : " + ", j, W[j]);
    }
    parts.curve =
        curve_text(step, *wishes.curve, chord, W, slopes_in_rows("Lp", form.form.nodes()));
}

bool has_adjoint(const Step& step) {
    const auto* form = std::get_if<GalerkinStep>(&step.form);
    return form != nullptr && form->has_adjoint;
}

std::string choice_of_tables(const GalerkinStep& form) {
    if (!form.has_adjoint) { return {}; }
    Writer writer(2);
    writer.line("bool is_adjoint;");
    writer.line("[[nodiscard]] const auto& table_A() const {{ return is_adjoint ? D : A; }}");
    writer.line("[[nodiscard]] const auto& table_D() const {{ return is_adjoint ? A : D; }}");
    return writer.str();
}

std::string_view table_A(const GalerkinStep& form) { return form.has_adjoint ? "table_A()" : "A"; }
std::string_view table_D(const GalerkinStep& form) { return form.has_adjoint ? "table_D()" : "D"; }

std::string_view adjoint_argument(const GalerkinStep& form) {
    return form.has_adjoint ? "is_adjoint_, " : "";
}

std::string adjoint_member(const GalerkinStep& form) {
    if (!form.has_adjoint) { return {}; }
    return Writer(1)
        .line("bool is_adjoint_ = false;  // the step of a composition that is taken")
        .str();
}

std::string tables_for_newton(const GalerkinStep& form) {
    Writer writer(2);
    for (const std::string_view table : {"X", "A", "D"}) {
        if (form.has_adjoint && table != "X") { continue; }
        writer.line("static constexpr const auto& table_{0}() {{ return {0}; }}", table);
    }
    return writer.str();
}

NumberVector inverses(const NumberVector& numbers) {
    NumberVector result;
    for (const Number& number : numbers) { result.push_back(Number(1) / number); }
    return result;
}

/// NOTE: the action counts several steps in a row as one: see composed_step.hpp.in.
std::string end_of_curve(const Step& step, const SceneWishes& wishes) {
    const std::string end = end_of_step(step, "status.iterations");
    if (wishes.action && step.in_a_row.empty()) {
        return end_with_action("integral_over_step()", end);
    }
    return Writer(2).line("return {};", end).str();
}

bool takes_fixed_points(const GalerkinStep& form) {
    return form.iteration.solver != Solver::newton;
}

}  // namespace hvi::gen
