// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/render/equations_page.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "generator/render/layout.hpp"

namespace hvi::gen {

namespace {

/// Returns the length of the text before the terms that the step size multiplies, in `q+h*(...)`; 0
/// for other expressions.
std::size_t length_before_slopes(const Expression& right) {
    if (right.kind != Expression::Kind::sum || right.arguments.size() != 2) return 0;
    const Expression& last = right.arguments.back();
    const Expression& change = last.kind == Expression::Kind::negation ? last.arguments[0] : last;
    const bool fits = change.kind == Expression::Kind::product && change.arguments.size() == 2 &&
                      change.arguments[0] == Expression::symbol("h") &&
                      change.arguments[1].kind == Expression::Kind::sum;
    return fits ? to_text(right.arguments[0]).size() + std::string_view("+h*(").size() : 0;
}

}  // namespace

void EquationsPage::line(const std::string& head, const std::string& text) {
    for (const std::string& line : wrapped(head, text)) text_ += line + "\n";
}

void EquationsPage::fact(std::string_view name, const std::string& text) {
    if (!text.empty()) line(fmt::format("{:<14}", name), text);
}

void EquationsPage::names(std::string_view name, const std::vector<std::string>& list) {
    fact(name, fmt::format("{}", fmt::join(list, ", ")));
}

void EquationsPage::equation(const std::string& left, const Expression& right) {
    const std::string text = to_text(right);
    std::string head = " " + left + " = ";
    const bool fits = head.size() + text.size() <= terminal_columns;
    const std::size_t begin = length_before_slopes(right);
    if (fits || right.kind != Expression::Kind::sum || begin != 0) {
        const std::size_t kept = fits ? 0 : begin;
        line(head + text.substr(0, kept), text.substr(kept));
        return;
    }
    for (const Expression& term : right.arguments) {
        std::string piece = to_text(term);
        const bool first = head.find('=') != std::string::npos;
        if (!first && piece.front() != '-') piece.insert(0, 1, '+');
        line(head, piece);
        head.assign(head.size(), ' ');
    }
}

void EquationsPage::parameters(const StepTitle& step) {
    names("parameters", step.parameters);
    std::string values;
    for (const Parameter& known : step.values)
        values +=
            fmt::format("{}{} = {}", values.empty() ? "" : ", ", known.name, to_text(known.value));
    fact("values", values);
    std::string functions;
    for (const Expression& psi : step.basis)
        functions += (functions.empty() ? "" : ", ") + to_text(psi);
    fact("basis", functions);
    remark("\n");
}

}  // namespace hvi::gen
