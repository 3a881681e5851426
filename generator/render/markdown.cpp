// A method as tables of GitHub's Markdown.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include "generator/render/entry.hpp"
#include "generator/render/render.hpp"

namespace hvi::gen {

namespace {

/// NOTE: our notation has no bar, the only character that would end a cell.
std::string code(const std::optional<std::string>& text) { return text ? "`" + *text + "`" : ""; }

std::string code(const Number& number, int digits) {
    return code(make_entry(number, digits).best_text());
}

std::string table_row(const std::string& head, const NumberVector& row, int digits) {
    std::string line = "| " + head + " |";
    for (const Number& number : row) line += " " + code(number, digits) + " |";
    return line + "\n";
}

/// Returns the table c | A with b below, under these names.
std::string butcher_table(std::string_view c_name, const NumberVector& c, std::string_view a_name,
                          std::string_view b_name, const NumberMatrix& A, const NumberVector& b,
                          int digits) {
    std::string text = fmt::format("| {} | {} |", c_name, a_name);
    for (std::size_t j = 1; j < b.size(); ++j) text += " |";
    text += "\n|---|";
    for (std::size_t j = 0; j < b.size(); ++j) text += "---|";
    text += "\n";
    for (std::size_t i = 0; i < c.size(); ++i) text += table_row(code(c[i], digits), A[i], digits);
    return text + table_row(fmt::format("**{}**", b_name), b, digits);
}

std::string list(const std::vector<std::string>& items) {
    std::string text;
    for (const std::string& item : items) text += (text.empty() ? "" : ", ") + code(item);
    return text;
}

std::string basis_text(const Provenance& provenance) {
    std::vector<std::string> basis;
    for (const Expression& function : provenance.basis) basis.push_back(to_text(function));
    return fmt::format("- basis functions: {}\n", list(basis));
}

std::string parameters_text(const std::vector<std::string>& names) {
    return names.empty() ? "" : "- parameters: " + list(names) + "\n";
}

std::string entries_text(const std::vector<Part>& parts, int digits) {
    std::string text = "\n## Entries\n\n| matrix | row | column | exact | decimal | double |\n"
                       "|---|---|---|---|---|---|\n";
    for_each_entry(parts, digits,
                   [&](const Part& part, std::size_t row, std::size_t column, const Entry& entry) {
                       text += fmt::format("| {} | {} | {} | {} | {} | {} |\n", part.name, row,
                                           column, code(entry.exact_text()), code(entry.decimal),
                                           code(entry.hex));
                   });
    return text;
}

}  // namespace

std::string render_markdown(const Tableau& tableau, int digits) {
    std::string text = fmt::format("# Tableau of `{}`\n\n", tableau.provenance.title());
    text += fmt::format("- stages: {}\n", tableau.stages()) + basis_text(tableau.provenance) +
            parameters_text(tableau.parameters);
    text += "\n" + butcher_table("c", tableau.c, "A", "b", tableau.A, tableau.b, digits);
    text += "\n" + butcher_table("c_tilde", tableau.c_tilde, "A_tilde", "b", tableau.A_tilde,
                                 tableau.b, digits);
    return text + entries_text(parts(tableau), digits);
}

std::string render_markdown(const GalerkinRule& rule, int digits) {
    std::string text = fmt::format("# General Galerkin form of `{}`\n\n", rule.provenance.title());
    text += fmt::format("- functions: {}\n- nodes: {}\n", rule.functions(), rule.nodes()) +
            basis_text(rule.provenance) + parameters_text(rule.parameters);
    const NystromTableau tableau = nystrom(rule);
    text += "\n" + butcher_table("c", rule.c, "A_psi", "B", rule.A_psi, rule.B, digits);
    text += "\nFor H = p^T K p/2 + U(q):\n\n" +
            butcher_table("c", rule.c, "A_bar", "b_bar", tableau.A_bar, tableau.b_bar, digits);
    return text + table_row("**b**", rule.b, digits) + entries_text(all_parts(rule), digits);
}

}  // namespace hvi::gen
