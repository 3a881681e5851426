// What steps of (4.6) and of (4.14) have in common: the tables of the general Galerkin form.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "generator/emit/steps/header.hpp"
#include "generator/emit/steps/implicit_parts.hpp"

namespace hvi::gen {

/// b, X, A, D and B, and c where the system depends on time. `equation` is the one they are of.
[[nodiscard]] std::string curve_tables(const Step& step, const GalerkinForm& form,
                                       const RoundedGalerkinForm& values,
                                       std::string_view equation);

/// Also the bends of the curve where it is wished for.
[[nodiscard]] std::string curve_tables(const Step& step, const GalerkinStep& form,
                                       const SceneWishes& wishes);

/// Adds position(tau) where it is wished for; its table is one of `curve_tables`.
void add_position(ImplicitParts& parts, const Step& step, const GalerkinStep& form,
                  const SceneWishes& wishes);

// ---- every second step one of the adjoint ----

[[nodiscard]] bool has_adjoint(const Step& step);
/// `bool is_adjoint;` and what it chooses, for the coupled equations; empty where there is none.
[[nodiscard]] std::string choice_of_tables(const GalerkinStep& form);
/// `A`, or what is chosen for it; and the same of D.
[[nodiscard]] std::string_view table_A(const GalerkinStep& form);
[[nodiscard]] std::string_view table_D(const GalerkinStep& form);
/// The first argument of the coupled equations behind the clock.
[[nodiscard]] std::string_view adjoint_argument(const GalerkinStep& form);
/// The member of the stepper that says of which a step is.
[[nodiscard]] std::string adjoint_member(const GalerkinStep& form);
/// The tables by their names, for Newton's method; those that are chosen are there.
[[nodiscard]] std::string tables_for_newton(const GalerkinStep& form);

/// 1/x of each.
[[nodiscard]] NumberVector inverses(const NumberVector& numbers);

/// The last lines of step(), or of one of several in a row.
[[nodiscard]] std::string end_of_curve(const Step& step, const SceneWishes& wishes);

/// Fixed points are iterated, at first or throughout.
[[nodiscard]] bool takes_fixed_points(const GalerkinStep& form);

}  // namespace hvi::gen
