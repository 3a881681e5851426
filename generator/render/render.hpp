// A method in the formats that people and programs read.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "generator/exact/methods/galerkin_rule.hpp"
#include "generator/exact/methods/tableau.hpp"

namespace hvi::gen {

// Decimals have `digits` significant digits (at least 1). Each result ends in a newline, and equal
// tableaux give equal bytes.

/// Writes for a terminal of 80 columns: c | A and c~ | A~ side by side where they fit, else one
/// below the other, else entry by entry; exact first, then as decimals. Decimals may have fewer
/// digits than up to 16 that were asked for, so that they fit into tables; the text says so.
[[nodiscard]] std::string render_text(const Tableau& tableau, int digits);

/// Writes the schema `hvi-tableau/1`.
[[nodiscard]] std::string render_json(const Tableau& tableau, int digits);

/// Writes the two tableaux side by side, as a displayed formula to paste; needs no package.
[[nodiscard]] std::string render_latex(const Tableau& tableau, int digits);

/// Writes both tableaux and a list of all entries as tables of GitHub's Markdown.
[[nodiscard]] std::string render_markdown(const Tableau& tableau, int digits);

/// Writes a line for each entry, by RFC 4180 but with the line ends of Unix.
[[nodiscard]] std::string render_csv(const Tableau& tableau, int digits);

/// Write the general Galerkin form (4.6): c | A_psi with B below, b | Psi^T, the Gram matrix, and
/// the Nystrom method c | A_bar with b_bar and b. The schema is `hvi-galerkin/1`.
[[nodiscard]] std::string render_text(const GalerkinRule& rule, int digits);
[[nodiscard]] std::string render_json(const GalerkinRule& rule, int digits);
[[nodiscard]] std::string render_latex(const GalerkinRule& rule, int digits);
[[nodiscard]] std::string render_markdown(const GalerkinRule& rule, int digits);
[[nodiscard]] std::string render_csv(const GalerkinRule& rule, int digits);

}  // namespace hvi::gen
