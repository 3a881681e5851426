// The equations of a step as a displayed formula of LaTeX.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <map>

#include "generator/render/equations.hpp"
#include "generator/render/loop_equations.hpp"

namespace hvi::gen {

namespace {

constexpr std::size_t longest_line = 160;  ///< roughly; longer source lines are broken

/// Returns a variable at the beginning of the step, q_{n}, or at its end, q_{n+1}.
std::string at(const std::string& variable, std::string_view time) {
    std::string text = to_latex(Expression::symbol(variable));
    const bool indexed = text.find("_{") != std::string::npos && text.back() == '}';
    if (!indexed) return fmt::format("{}_{{{}}}", text, time);
    text.pop_back();
    return fmt::format("{},{}}}", text, time);
}

/// Returns these forms of all variables, as names for symbols.
std::map<std::string, std::string> names_at(const std::vector<std::string>& variables,
                                            std::string_view time) {
    std::map<std::string, std::string> names;
    for (const std::string& variable : variables) names[variable] = at(variable, time);
    return names;
}

/// A sum whose terms are broken into lines where they get long.
class Sum {
public:
    void add(const Expression& coefficient, const std::string& variable) {
        if (coefficient == Expression::integer(0)) return;
        const bool sum = coefficient.kind == Expression::Kind::sum;
        std::string factor = to_latex(coefficient);
        const bool negative = !sum && factor.front() == '-';
        if (negative) factor.erase(0, 1);
        if (variable.empty()) {
            append(negative, factor);
        } else if (factor == "1") {
            append(negative, variable);
        } else {
            append(negative, (sum ? "\\left(" + factor + "\\right) " : factor + " ") + variable);
        }
    }

    [[nodiscard]] std::string text() const { return text_.empty() ? "0" : text_; }

private:
    void append(bool negative, const std::string& term) {
        if (text_.empty()) {
            text_ = (negative ? "-" : "") + term;
            return;
        }
        const std::size_t line = std::min(text_.rfind("\\\\\n"), text_.size());
        const std::size_t length = line == text_.size() ? line : text_.size() - line;
        text_ += length + term.size() > longest_line ? " \\\\\n&\\quad {}" : "";
        text_ += (negative ? " - " : " + ") + term;
    }

    std::string text_;
};

/// Appends a line.
void append_line(std::string& lines, const std::string& line) {
    lines += (lines.empty() ? "" : ", \\\\\n") + line;
}

std::string map_latex(const StepEquations& step) {
    const std::vector<std::string> names = variables(step);
    std::string lines;
    for (std::size_t i = 0; i < names.size(); ++i) {
        Sum sum;
        for (std::size_t j = 0; j < names.size(); ++j)
            sum.add(step.map->matrix[i][j], at(names[j], "n"));
        sum.add(step.map->offset[i], "");
        append_line(lines, fmt::format("{} &= {}", at(names[i], "n+1"), sum.text()));
    }
    return lines;
}

std::string stages_latex(const StepEquations& step) {
    std::map<std::string, std::string> now = names_at(variables(step), "n");
    now["t"] = at("t", "n");
    std::string lines;
    const auto append = [&](const std::string& left, const Expression& right) {
        append_line(lines, fmt::format("{} &= {}", left, to_latex(renamed(right, now))));
    };
    for (const Equation& stage : step.stages->stages)
        append(to_latex(Expression::symbol(stage.left)), stage.right);
    for (const Equation& update : step.stages->update) append(at(update.left, "n+1"), update.right);
    return lines;
}

/// Appends the equations to `lines`. `now` are names of the values at the beginning of the step.
std::string galerkin_latex(const GalerkinEquations& equations,
                           const std::map<std::string, std::string>& now, std::string lines = "") {
    const auto append = [&](const std::string& left, const Expression& right) {
        lines += fmt::format("{}{} &= {}", lines.empty() ? "" : ", \\\\\n", left,
                             to_latex(renamed(right, now)));
    };
    for (const Equation& position : equations.positions)
        append(to_latex(Expression::symbol(position.left)), position.right);
    for (const ImplicitEquation& condition : equations.conditions)
        append(to_latex(condition.left), condition.right);
    for (const Equation& update : equations.update) append(at(update.left, "n+1"), update.right);
    return lines;
}

std::string at_nodes_latex(const StepEquations& step) {
    std::map<std::string, std::string> now = names_at(variables(step), "n");
    now["t"] = at("t", "n");
    return galerkin_latex(*step.at_nodes, now);
}

/// Returns the map of a quadratic H, else the equations for a tableau or for the general form.
std::string step_latex(const StepEquations& step) {
    if (step.map) return map_latex(step);
    return step.stages ? stages_latex(step) : at_nodes_latex(step);
}

/// Writes H_d^+(q_n, p_{n+1}), term by term.
std::string function_latex(const std::string& left, const Expression& function,
                           const StepEquations& step) {
    std::map<std::string, std::string> names = names_at(step.coordinates, "n");
    names.merge(names_at(step.momenta, "n+1"));
    names["t"] = at("t", "n");
    const Expression shown = renamed(function, names);
    Sum sum;
    if (shown.kind == Expression::Kind::sum)
        for (const Expression& term : shown.arguments) sum.add(term, "");
    else
        sum.add(shown, "");
    return fmt::format("{} &= {}", left, sum.text());
}

/// Appends the coefficients of powers of h: [h^2] of a function. Coefficients that are too long are
/// left out.
void append_series(std::string& lines, const StepEquations& step) {
    const DiscreteSeries& series = *step.series;
    const auto append = [&](int power, std::string_view of,
                            const DiscreteSeries::Coefficient& coefficient) {
        if (!coefficient) return;
        append_line(lines,
                    function_latex(fmt::format("[h^{{{}}}]\\,{}", power, of), *coefficient, step));
    };
    const auto append_all = [&](std::string_view of,
                                const std::vector<DiscreteSeries::Coefficient>& terms) {
        int power = 0;
        for (const auto& term : terms) append(++power, of, term);
    };
    append_all("H_{d,\\mathrm{exact}}^{+}", series.exact);
    append_all("H_{d}^{+}", series.method);
    if (series.first_difference)
        append(*series.first_difference, "(H_{d}^{+} - H_{d,\\mathrm{exact}}^{+})",
               series.difference);
}

/// Returns `\\frac{\\partial H}{\\partial x_{k}}`, by the name of the derivative.
std::map<std::string, std::string> slopes_latex(const LoopEquations& step) {
    std::map<std::string, std::string> result;
    for (const auto* families : {&step.coordinates, &step.momenta})
        for (const SystemFamily& family : *families)
            result[slope_name(family, step.gradient.indices)] = fmt::format(
                "\\partial_{{{}}} H", to_latex(element_of(family, step.gradient.indices)));
    return result;
}

/// Replaces derivatives at values of a stage by symbols in LaTeX.
Expression with_slopes(Expression expression, const std::map<std::string, std::string>& slopes) {
    const auto found = slopes.find(expression.name);
    if (found != slopes.end()) {
        std::string stage;
        for (const Expression& argument : expression.arguments)
            stage += (stage.empty() ? "" : ", ") + to_latex(argument);
        return Expression::symbol(found->second + (stage.empty() ? "" : "(" + stage + ")"));
    }
    for (Expression& argument : expression.arguments)
        argument = with_slopes(std::move(argument), slopes);
    return expression;
}

/// Returns `1 \le k \le N`, or `k = 1`.
std::string range_latex(const Loop& range) {
    const auto& [first, last] = range.range;
    const std::string index = to_latex(Expression::symbol(range.index));
    const std::string begin = to_latex(as_expression(first));
    if (first == last) return fmt::format("{} = {}", index, begin);
    return fmt::format("{} \\le {} \\le {}", begin, index, to_latex(as_expression(last)));
}

/// Returns the terms of a derivative, each with its ranges unless it is everywhere.
std::string slope_latex(const ElementSlope& slope) {
    std::string text;
    for (const PlacedTerm& term : placed_terms(slope, true)) {
        text += (text.empty() ? "" : " \\\\\n&\\quad {}") + term.text;
        std::string before = " \\quad \\text{for } ";
        for (const Loop& range : term.where) {
            text += before + range_latex(range);
            before = ",\\ ";
        }
    }
    return text;
}

std::string loops_latex(const LoopEquations& step) {
    const std::map<std::string, std::string> slopes = slopes_latex(step);
    std::map<std::string, std::string> now{{"t", at("t", "n")}};
    for (const auto* families : {&step.coordinates, &step.momenta})
        for (const SystemFamily& family : *families) {
            const std::string name = to_text(element_of(family, step.gradient.indices));
            now[name] = at(name, "n");
        }
    std::string lines;
    const auto append = [&](const std::string& left, const Expression& right) {
        append_line(lines, fmt::format("{} &= {}", left,
                                       to_latex(renamed(with_slopes(right, slopes), now))));
    };
    for (const Equation& stage : step.stages.stages)
        append(to_latex(Expression::symbol(stage.left)), stage.right);
    for (const Equation& update : step.stages.update) append(at(update.left, "n+1"), update.right);
    for (const auto& [family, slope] : named_slopes(step))
        append_line(lines,
                    fmt::format("{} &= {}", slopes.at(slope_name(family, step.gradient.indices)),
                                slope_latex(slope)));
    return lines;
}

std::string displayed(const std::string& command, const std::string& lines) {
    return fmt::format("% hvi-gen scheme {} --format latex\n"
                       "% needs \\usepackage{{amsmath}}\n"
                       "\\[\n\\begin{{aligned}}\n{}.\n\\end{{aligned}}\n\\]\n",
                       command, lines);
}

}  // namespace

std::string render_latex(const StepEquations& step) {
    std::string lines = step_latex(step);
    std::string option;
    if (step.generating) {
        option = " --generating";
        append_line(lines, function_latex("H_{d}^{+}", step.generating->discrete, step));
        if (step.generating->exact)
            append_line(lines,
                        function_latex("H_{d,\\mathrm{exact}}^{+}", *step.generating->exact, step));
    }
    if (step.series) {
        option += fmt::format(" --series {}", step.series->exact.size());
        append_series(lines, step);
    }
    return displayed(step.origin + option, lines);
}

std::string render_latex(const LagrangianEquations& step) {
    std::map<std::string, std::string> now = names_at(step.coordinates, "n");
    now.merge(names_at(step.momenta, "n"));
    now["t"] = at("t", "n");
    const std::string lines = galerkin_latex(step, now, "L &= " + to_latex(step.lagrangian));
    return displayed(step.origin + " --lagrangian", lines);
}

std::string render_latex(const LoopEquations& step) {
    return displayed(step.origin, loops_latex(step));
}

}  // namespace hvi::gen
