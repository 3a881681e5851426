// The general Galerkin form for people, in a terminal of 80 columns.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include "generator/exact/algebra/matrix.hpp"
#include "generator/render/entry.hpp"
#include "generator/render/render.hpp"
#include "generator/render/text_parts.hpp"

namespace hvi::gen {

namespace {

std::vector<std::string> texts(const NumberVector& numbers, auto form) {
    std::vector<std::string> result;
    for (const Number& number : numbers) result.push_back(form(number));
    return result;
}

Cells cells(const NumberMatrix& rows, auto form) {
    Cells result;
    for (const NumberVector& row : rows) result.push_back(texts(row, form));
    return result;
}

std::optional<std::string> fitting(const Table& table) {
    const Lines lines = table_lines(table);
    if (width(lines) > terminal_columns) return {};
    std::string text;
    append(text, lines);
    return text + "\n";
}

/// Returns tables, if the terminal has room for them.
std::optional<std::string> as_tables(const GalerkinRule& rule, auto form) {
    const NystromTableau tableau = nystrom(rule);
    const std::vector<std::string> c = texts(rule.c, form), B = texts(rule.B, form);
    const auto A_psi = fitting({"c", "A_psi", c, cells(rule.A_psi, form), "B", B});
    const auto Psi =
        fitting({"b", "Psi^T", texts(rule.b, form), cells(transpose(rule.Psi), form), "B", B});
    const auto A_bar =
        fitting({"c", "A_bar", c, cells(tableau.A_bar, form), "b_bar", texts(tableau.b_bar, form)});
    if (!A_psi || !Psi || !A_bar) return {};
    return *A_psi + *Psi + matrix_entries("G", cells(rule.gram, form)) +
           "for H = p^T K p/2 + U(q), with the weights b above\n\n" + *A_bar;
}

std::string entry_by_entry(const GalerkinRule& rule, auto form) {
    const NystromTableau tableau = nystrom(rule);
    return vector_entries("c", texts(rule.c, form)) + vector_entries("b", texts(rule.b, form)) +
           vector_entries("B", texts(rule.B, form)) + matrix_entries("Psi", cells(rule.Psi, form)) +
           matrix_entries("A_psi", cells(rule.A_psi, form)) +
           matrix_entries("G", cells(rule.gram, form)) +
           "for H = p^T K p/2 + U(q), with these weights b\n\n" +
           matrix_entries("A_bar", cells(tableau.A_bar, form)) +
           vector_entries("b_bar", texts(tableau.b_bar, form));
}

/// Returns all numbers in one form, exact or decimal.
std::string shown(const GalerkinRule& rule, auto form) {
    const auto tables = as_tables(rule, form);
    return tables ? *tables : entry_by_entry(rule, form);
}

}  // namespace

std::string render_text(const GalerkinRule& rule, int digits) {
    std::string text =
        heading(rule.provenance, rule.parameters,
                fmt::format("functions   {}\nnodes       {}\n", rule.functions(), rule.nodes()));
    text +=
        shown(rule, [&](const Number& number) { return make_entry(number, digits).best_text(); });
    if (rule.parameters.empty()) {
        text += fmt::format("to {} digits\n\n", digits);
        text += shown(rule, [&](const Number& number) { return number.decimal(digits); });
    }
    text.pop_back();
    return text;
}

}  // namespace hvi::gen
