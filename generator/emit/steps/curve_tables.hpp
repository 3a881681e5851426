// What steps of (4.6) and of (4.14) have in common: the tables of the general Galerkin form.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "generator/emit/steps/header.hpp"
#include "generator/emit/steps/implicit_parts.hpp"

namespace hvi::gen {

/// b, X, A, D and B, and c where the system depends on time; the bends of the curve where it is
/// wished for.
[[nodiscard]] std::string curve_tables(const Step& step, const GalerkinStep& form,
                                       const SceneWishes& wishes);

/// Adds position(tau) where it is wished for; its table is one of `curve_tables`.
void add_position(ImplicitParts& parts, const GalerkinStep& form, const SceneWishes& wishes);

/// The parts of a composition; empty where there is none.
[[nodiscard]] std::string gamma_table(const GalerkinStep& form);

/// Each entry rounded on its own: for starting values, and for the way to a solution.
void rough_table(Writer& writer, std::string_view name, const NumberMatrix& exact);
/// `formula` is what comments call the entries.
void rough_table(Writer& writer, std::string_view name, std::string_view formula,
                 const NumberVector& exact);

/// 1/x of each.
[[nodiscard]] NumberVector inverses(const NumberVector& numbers);

/// The last lines of step(), or of one of several in a row.
[[nodiscard]] std::string end_of_curve(const Step& step, const GalerkinStep& form,
                                       const SceneWishes& wishes);

/// Fixed points are iterated, at first or throughout.
[[nodiscard]] bool takes_fixed_points(const GalerkinStep& form);

}  // namespace hvi::gen
