// A method in the formats that people and programs read.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "generator/exact/methods/galerkin_rule.hpp"
#include "generator/exact/methods/tableau.hpp"

namespace hvi::gen {

// Decimals have `digits` significant digits (at least 1). Each result ends in a newline, and the
// same tableau gives the same bytes.

/// For a terminal of 80 columns: c | A and c~ | A~ side by side where they fit, else one below the
/// other, else entry by entry; exact first, then as decimals. Where it says so, decimals have fewer
/// digits than up to 16 that were asked for, so that they fit into tables.
[[nodiscard]] std::string render_text(const Tableau& tableau, int digits);

/// The schema `hvi-tableau/1`.
[[nodiscard]] std::string render_json(const Tableau& tableau, int digits);

/// The two tableaux side by side, as a displayed formula to paste; needs no package.
[[nodiscard]] std::string render_latex(const Tableau& tableau, int digits);

/// Both tableaux and a list of all entries as tables of GitHub's Markdown.
[[nodiscard]] std::string render_markdown(const Tableau& tableau, int digits);

/// A line for each entry, as RFC 4180 has it but for line ends, which are those of Unix.
[[nodiscard]] std::string render_csv(const Tableau& tableau, int digits);

/// The same of the general Galerkin form (4.6): c | A_psi with B below, b | Psi^T, the Gram matrix,
/// and the Nystrom method c | A_bar with b_bar and b; the schema is `hvi-galerkin/1`.
[[nodiscard]] std::string render_text(const GalerkinRule& rule, int digits);
[[nodiscard]] std::string render_json(const GalerkinRule& rule, int digits);
[[nodiscard]] std::string render_latex(const GalerkinRule& rule, int digits);
[[nodiscard]] std::string render_markdown(const GalerkinRule& rule, int digits);
[[nodiscard]] std::string render_csv(const GalerkinRule& rule, int digits);

}  // namespace hvi::gen
