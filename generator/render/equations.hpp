// The equations of a step, for people, papers and programs.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "generator/equations/lagrangian_equations.hpp"
#include "generator/equations/loop_equations.hpp"
#include "generator/equations/step_equations.hpp"

namespace hvi::gen {

/// Write for a terminal of 80 columns; q' is q at the end of the step.
[[nodiscard]] std::string render_text(const StepEquations& step);
[[nodiscard]] std::string render_text(const LagrangianEquations& step);
[[nodiscard]] std::string render_text(const LoopEquations& step);

/// Writes the schema `hvi-scheme/1`.
[[nodiscard]] std::string render_json(const StepEquations& step);

/// Writes the schema `hvi-scheme-lagrangian/1`.
[[nodiscard]] std::string render_json(const LagrangianEquations& step);

/// Writes the schema `hvi-scheme-loops/1`.
[[nodiscard]] std::string render_json(const LoopEquations& step);

/// Write a displayed formula to paste, for amsmath: from q_n to q_{n+1} as in Section 6 of the
/// paper.
[[nodiscard]] std::string render_latex(const StepEquations& step);
[[nodiscard]] std::string render_latex(const LagrangianEquations& step);
[[nodiscard]] std::string render_latex(const LoopEquations& step);

}  // namespace hvi::gen
