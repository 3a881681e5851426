// Tables of the general Galerkin form, for steps of (4.6) and of (4.14).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "generator/emit/steps/header.hpp"
#include "generator/emit/steps/implicit_parts.hpp"

namespace hvi::gen {

/// Returns the tables b, X, A, D and B, and c where the system depends on time. `equation` is the
/// number of their equation.
[[nodiscard]] std::string curve_tables(const Step& step, const GalerkinForm& form,
                                       const RoundedGalerkinForm& values,
                                       std::string_view equation);

/// Returns the tables, with the bends of the curve where position(tau) is wished for.
[[nodiscard]] std::string curve_tables(const Step& step, const GalerkinStep& form,
                                       const SceneWishes& wishes);

/// Adds position(tau) where it is wished for; its table is one of `curve_tables`.
void add_position(ImplicitParts& parts, const Step& step, const GalerkinStep& form,
                  const SceneWishes& wishes);

// ---- the adjoint in every second step ----

[[nodiscard]] bool has_adjoint(const Step& step);
/// Returns `bool is_adjoint;` and the tables that it chooses, for the coupled equations; empty
/// where there is no adjoint.
[[nodiscard]] std::string choice_of_tables(const GalerkinStep& form);
/// Return `A` and `D`, or the expressions that choose between them.
[[nodiscard]] std::string_view table_A(const GalerkinStep& form);
[[nodiscard]] std::string_view table_D(const GalerkinStep& form);
/// Returns the argument of the coupled equations that follows the clock.
[[nodiscard]] std::string_view adjoint_argument(const GalerkinStep& form);
/// Returns the member of the stepper that tells a step of the method from one of the adjoint.
[[nodiscard]] std::string adjoint_member(const GalerkinStep& form);
/// Returns members for Newton's method with the tables under their names, except tables that
/// choice_of_tables() has already.
[[nodiscard]] std::string tables_for_newton(const GalerkinStep& form);

/// Returns 1/x of each number.
[[nodiscard]] NumberVector inverses(const NumberVector& numbers);

/// Returns the last lines of step(), or of one of several steps in a row.
[[nodiscard]] std::string end_of_curve(const Step& step, const SceneWishes& wishes);

/// Returns whether fixed points are iterated, at first or throughout.
[[nodiscard]] bool takes_fixed_points(const GalerkinStep& form);

}  // namespace hvi::gen
