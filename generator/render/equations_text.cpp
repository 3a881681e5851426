// The equations of a step for people, in a terminal of 80 columns.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <map>

#include "generator/render/equations.hpp"
#include "generator/render/layout.hpp"

namespace hvi::gen {

namespace {

/// The new value of a variable: a row of the map, without what is zero.
Expression new_value(const MapEquations& map, std::size_t row,
                     const std::vector<std::string>& names) {
    const Expression zero = Expression::integer(0), one = Expression::integer(1);
    std::vector<Expression> terms;
    for (std::size_t j = 0; j < names.size(); ++j) {
        const Expression& entry = map.matrix[row][j];
        const Expression variable = Expression::symbol(names[j]);
        if (entry == zero) continue;
        terms.push_back(entry == one ? variable : Expression::product({entry, variable}));
    }
    if (!(map.offset[row] == zero)) terms.push_back(map.offset[row]);
    return Expression::sum(std::move(terms));
}

/// Momenta with a prime.
std::map<std::string, std::string> names_at_the_end(const StepEquations& step) {
    std::map<std::string, std::string> names;
    for (const std::string& name : step.momenta) names[name] = name + "'";
    return names;
}

/// q*p', and a sum of that over all degrees of freedom.
std::string identity(const StepEquations& step) {
    std::vector<std::string> products;
    for (std::size_t i = 0; i < step.momenta.size(); ++i)
        products.push_back(step.coordinates[i] + "*" + step.momenta[i] + "'");
    return fmt::format("{}", fmt::join(products, "+"));
}

/// Lines of a name and what is said of it, and equations.
class Page {
public:
    explicit Page(const StepEquations& step) : step_(step) {}

    [[nodiscard]] std::string text();

private:
    void line(const std::string& head, const std::string& text) {
        for (const std::string& line : wrapped(head, text)) text_ += line + "\n";
    }
    void fact(std::string_view name, const std::string& text) {
        if (!text.empty()) line(fmt::format("{:<14}", name), text);
    }
    void equation(const std::string& left, const Expression& right);
    void head();
    void map();
    void stages();
    void generating();
    void series();
    void term(std::size_t k, const DiscreteSeries::Coefficient& coefficient);
    void terms(const std::vector<DiscreteSeries::Coefficient>& coefficients);

    const StepEquations& step_;
    std::string text_;
};

/// How much stands before the terms that the step size multiplies, in `q+h*(...)`; 0 where it is no
/// such sum.
std::size_t length_before_slopes(const Expression& right) {
    if (right.kind != Expression::Kind::sum || right.arguments.size() != 2) return 0;
    const Expression& last = right.arguments.back();
    const Expression& change = last.kind == Expression::Kind::negation ? last.arguments[0] : last;
    const bool fits = change.kind == Expression::Kind::product && change.arguments.size() == 2 &&
                      change.arguments[0] == Expression::symbol("h") &&
                      change.arguments[1].kind == Expression::Kind::sum;
    return fits ? to_text(right.arguments[0]).size() + std::string_view("+h*(").size() : 0;
}

/// A long one is broken between the terms that the step size multiplies, or has a line for each of
/// its terms.
void Page::equation(const std::string& left, const Expression& right) {
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

void Page::head() {
    line("", step_.name.empty() ? step_.origin : step_.name);
    text_ += "\n";
    fact("hamiltonian", to_text(step_.hamiltonian));
    fact("coordinates", fmt::format("{}", fmt::join(step_.coordinates, ", ")));
    fact("momenta", fmt::format("{}", fmt::join(step_.momenta, ", ")));
    fact("parameters", fmt::format("{}", fmt::join(step_.parameters, ", ")));
    std::string values;
    for (const Parameter& known : step_.values)
        values +=
            fmt::format("{}{} = {}", values.empty() ? "" : ", ", known.name, to_text(known.value));
    fact("values", values);
    text_ += "\n";
}

void Page::map() {
    const std::vector<std::string> names = variables(step_);
    for (std::size_t i = 0; i < names.size(); ++i)
        equation(names[i] + "'", new_value(*step_.map, i, names));
}

void Page::stages() {
    const StageEquations& equations = *step_.stages;
    if (!step_.obstacle.empty()) {
        line("", "H is quadratic, but the map has no formula here: " + step_.obstacle);
        text_ += "\n";
    }
    if (!equations.is_explicit) text_ += "stages, to be solved together:\n\n";
    for (const Equation& stage : equations.stages) equation(stage.left, stage.right);
    if (!equations.is_explicit) text_ += "\nand with them:\n\n";
    for (const Equation& update : equations.update) equation(update.left + "'", update.right);
    if (equations.is_explicit) text_ += "\nEach line needs those above it only.\n";
    if (!equations.is_exact)
        text_ += "\nA decimal stands where there is no closed form, to 20 digits.\n";
}

void Page::generating() {
    const GeneratingEquations& found = *step_.generating;
    const auto at_the_end = names_at_the_end(step_);
    text_ += "\ngenerating function of type II, by (4.19):\n\n";
    equation("H_d^+", renamed(found.discrete, at_the_end));
    if (found.exact) {
        text_ += "\nexact discrete Hamiltonian, (4.1):\n\n";
        equation("H_d,exact^+", renamed(*found.exact, at_the_end));
    }
    text_ += "\n";
    fact("gives map", fmt::format("{}, by p = D_1 H_d^+ and q' = D_2 H_d^+ (3.10)",
                                  found.gives_map ? "yes" : "no"));
    fact("symmetric", found.is_symmetric ? "yes, the mixed second derivatives agree"
                                         : "no, the mixed second derivatives differ");
    fact("difference", fmt::format("H_d^+ - H_d,exact^+ = O(h^{}){}", found.order_of_difference,
                                   found.is_at_least ? " at least" : ""));
}

/// [h^k] is the coefficient of h^k.
void Page::term(std::size_t k, const DiscreteSeries::Coefficient& coefficient) {
    const std::string power = k == 1 ? "h" : fmt::format("h^{}", k);
    line(fmt::format(" [{}] = ", power),
         coefficient ? to_text(renamed(*coefficient, names_at_the_end(step_)))
                     : "... (too long to be computed)");
}

void Page::terms(const std::vector<DiscreteSeries::Coefficient>& coefficients) {
    line(" [1] = ", identity(step_));
    for (std::size_t k = 1; k <= coefficients.size(); ++k) term(k, coefficients[k - 1]);
}

void Page::series() {
    const DiscreteSeries& found = *step_.series;
    text_ += "\ncoefficients of powers of h in the exact discrete Hamiltonian, (4.1):\n\n";
    terms(found.exact);
    text_ += "\nand in the H_d^+ of the method, (4.19):\n\n";
    terms(found.method);
    text_ += "\n";
    if (found.first_difference) {
        const auto power = static_cast<std::size_t>(*found.first_difference);
        fact("difference",
             fmt::format("H_d^+ - H_d,exact^+ = O(h^{}), and {}", power,
                         found.difference ? "its first coefficient is" : "that is not 0"));
        if (!found.difference) return;
        text_ += "\n";
        term(power, found.difference);
    } else if (found.undecided) {
        fact("difference",
             fmt::format("none before h^{}, and there it is not decided", *found.undecided));
    } else {
        fact("difference", fmt::format("none up to h^{}", found.exact.size()));
    }
}

std::string Page::text() {
    head();
    if (step_.map) map();
    if (step_.stages) stages();
    if (step_.generating) generating();
    if (step_.series) series();
    return text_;
}

}  // namespace

std::string render_text(const StepEquations& step) { return Page(step).text(); }

}  // namespace hvi::gen
