// A tableau as a displayed formula of LaTeX, the two halves side by side.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include "generator/render/entry.hpp"
#include "generator/render/render.hpp"

namespace hvi::gen {

namespace {

/// `1.5e-20` as a product with a power of ten.
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

}  // namespace

std::string render_latex(const Tableau& tableau, int digits) {
    return fmt::format("% hvi-gen tableau {} --format latex\n", tableau.provenance.origin) +
           "\\[\n\\renewcommand{\\arraystretch}{1.5}\n" +
           array(tableau.c, tableau.A, tableau.b, digits) + "\\qquad\n" +
           array(tableau.c_tilde, tableau.A_tilde, tableau.b, digits) + "\\]\n";
}

}  // namespace hvi::gen
