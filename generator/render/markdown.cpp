// A tableau as tables of GitHub's Markdown.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include "generator/render/entry.hpp"
#include "generator/render/render.hpp"

namespace hvi::gen {

namespace {

/// Our notation has no bar, which alone would end a cell.
std::string code(const std::optional<std::string>& text) { return text ? "`" + *text + "`" : ""; }

std::string code(const Number& number, int digits) {
    return code(make_entry(number, digits).best_text());
}

std::string table_row(const std::string& head, const NumberVector& row, int digits) {
    std::string line = "| " + head + " |";
    for (const Number& number : row) line += " " + code(number, digits) + " |";
    return line + "\n";
}

/// c | A with b below; `c_name` and `a_name` stand in the head.
std::string butcher_table(std::string_view c_name, const NumberVector& c, std::string_view a_name,
                          const NumberMatrix& A, const NumberVector& b, int digits) {
    std::string text = fmt::format("| {} | {} |", c_name, a_name);
    for (std::size_t j = 1; j < b.size(); ++j) text += " |";
    text += "\n|---|";
    for (std::size_t j = 0; j < b.size(); ++j) text += "---|";
    text += "\n";
    for (std::size_t i = 0; i < c.size(); ++i) text += table_row(code(c[i], digits), A[i], digits);
    return text + table_row("**b**", b, digits);
}

std::string list(const std::vector<std::string>& items) {
    std::string text;
    for (const std::string& item : items) text += (text.empty() ? "" : ", ") + code(item);
    return text;
}

}  // namespace

std::string render_markdown(const Tableau& tableau, int digits) {
    std::vector<std::string> basis;
    for (const Expression& function : tableau.provenance.basis) basis.push_back(to_text(function));
    std::string text = fmt::format("# Tableau of `{}`\n\n", tableau.provenance.title());
    text += fmt::format("- stages: {}\n- basis functions: {}\n", tableau.stages(), list(basis));
    if (!tableau.parameters.empty()) text += "- parameters: " + list(tableau.parameters) + "\n";
    text += "\n" + butcher_table("c", tableau.c, "A", tableau.A, tableau.b, digits);
    text += "\n" + butcher_table("c_tilde", tableau.c_tilde, "A_tilde", tableau.A_tilde, tableau.b,
                                 digits);
    text += "\n## Entries\n\n| matrix | row | column | exact | decimal | double |\n"
            "|---|---|---|---|---|---|\n";
    for_each_entry(tableau, digits,
                   [&](const Part& part, std::size_t row, std::size_t column, const Entry& entry) {
                       text += fmt::format("| {} | {} | {} | {} | {} | {} |\n", part.name, row,
                                           column, code(entry.exact_text()), code(entry.decimal),
                                           code(entry.hex));
                   });
    return text;
}

}  // namespace hvi::gen
