// A method as displayed formulas of LaTeX.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include "generator/exact/algebra/matrix.hpp"
#include "generator/render/entry.hpp"
#include "generator/render/render.hpp"

namespace hvi::gen {

namespace {

/// Writes `1.5e-20` as a product with a power of ten.
std::string decimal_latex(const std::string& decimal) {
    const std::size_t e = decimal.find('e');
    if (e == std::string::npos) return decimal;
    return fmt::format("{} \\cdot 10^{{{}}}", decimal.substr(0, e),
                       std::stol(decimal.substr(e + 1)));
}

std::string cell(const Number& number, int digits) {
    const Entry entry = make_entry(number, digits);
    return entry.exact ? to_latex(*entry.exact) : decimal_latex(entry.decimal.value_or("?"));
}

std::string row_line(const std::string& head, const NumberVector& row, int digits) {
    std::string line = head;
    for (const Number& number : row) line += " & " + cell(number, digits);
    return line;
}

std::string array(const NumberVector& c, const NumberMatrix& A, const NumberVector& b, int digits) {
    std::string text = fmt::format("\\begin{{array}}{{c|{}}}\n", std::string(b.size(), 'c'));
    for (std::size_t i = 0; i < c.size(); ++i)
        text += row_line(cell(c[i], digits), A[i], digits) + " \\\\\n";
    return text + "\\hline\n" + row_line("", b, digits) + "\n\\end{array}\n";
}

std::string matrix(const NumberMatrix& rows, int digits) {
    std::string text =
        fmt::format("\\left(\\begin{{array}}{{{}}}\n", std::string(rows.size(), 'c'));
    for (std::size_t i = 0; i < rows.size(); ++i) {
        text += cell(rows[i][0], digits);
        for (std::size_t j = 1; j < rows[i].size(); ++j) text += " & " + cell(rows[i][j], digits);
        text += i + 1 < rows.size() ? " \\\\\n" : "\n";
    }
    return text + "\\end{array}\\right)\n";
}

}  // namespace

std::string render_latex(const Tableau& tableau, int digits) {
    return fmt::format("% hvi-gen tableau {} --format latex\n", tableau.provenance.origin) +
           "\\[\n\\renewcommand{\\arraystretch}{1.5}\n" +
           array(tableau.c, tableau.A, tableau.b, digits) + "\\qquad\n" +
           array(tableau.c_tilde, tableau.A_tilde, tableau.b, digits) + "\\]\n";
}

std::string render_latex(const GalerkinRule& rule, int digits) {
    const NystromTableau tableau = nystrom(rule);
    std::string text =
        fmt::format("% hvi-gen tableau {} --format latex\n", rule.provenance.origin) +
        "% A_psi with B, Psi^T with the weights in front, the Gram matrix; (4.6)\n"
        "\\[\n\\renewcommand{\\arraystretch}{1.5}\n" +
        array(rule.c, rule.A_psi, rule.B, digits) + "\\qquad\n" +
        array(rule.b, transpose(rule.Psi), rule.B, digits) + "\\qquad\n" +
        matrix(rule.gram, digits) + "\\]\n";
    text += "% for H = p^T K p/2 + U(q), with b_bar and b below\n"
            "\\[\n\\renewcommand{\\arraystretch}{1.5}\n" +
            array(rule.c, tableau.A_bar, tableau.b_bar, digits);
    constexpr std::string_view end = "\n\\end{array}\n";
    text.erase(text.size() - end.size());
    return text + " \\\\\n" + row_line("", rule.b, digits) + std::string(end) + "\\]\n";
}

}  // namespace hvi::gen
