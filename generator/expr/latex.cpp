// Expressions in LaTeX's mathematics.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "generator/expr/fraction.hpp"
#include "generator/expr/functions.hpp"

namespace hvi::gen {

namespace {

/// Styles of fractions: stacked, or with a slash in small type and within a line, that is in
/// exponents and in arguments of functions.
enum class Bar { stacked, slash };

std::string latex(const Expression& expression, Bar bar);

std::string in_sized_parentheses(const std::string& text) { return "\\left(" + text + "\\right)"; }

bool is_letter(char c) { return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z'); }

bool is_digit(char c) { return '0' <= c && c <= '9'; }

bool is_greek(std::string_view word) {
    static constexpr std::array<std::string_view, 34> letters{
        "alpha",   "beta",   "gamma", "delta",   "epsilon", "zeta",  "eta",   "theta", "iota",
        "kappa",   "lambda", "mu",    "nu",      "xi",      "pi",    "rho",   "sigma", "tau",
        "upsilon", "phi",    "chi",   "psi",     "omega",   "Gamma", "Delta", "Theta", "Lambda",
        "Xi",      "Pi",     "Sigma", "Upsilon", "Phi",     "Psi",   "Omega"};
    return std::find(letters.begin(), letters.end(), word) != letters.end();
}

/// Returns a word of a name: a letter, a Greek letter, digits, or a longer word in italics.
std::string word_latex(std::string_view word) {
    if (is_greek(word)) return "\\" + std::string(word);
    if (word.size() == 1 && word != "_") return std::string(word);
    if (std::all_of(word.begin(), word.end(), is_digit)) return std::string(word);
    std::string escaped;
    for (const char c : word) escaped += c == '_' ? std::string("\\_") : std::string(1, c);
    return "\\mathit{" + escaped + "}";
}

/// Splits a name at `_`; digits at the end of the first part are a part of their own. Returns only
/// the name itself when a part is empty.
std::vector<std::string_view> words_of(std::string_view name) {
    std::vector<std::string_view> words;
    for (std::size_t begin = 0; begin <= name.size();) {
        const std::size_t end = std::min(name.find('_', begin), name.size());
        words.push_back(name.substr(begin, end - begin));
        begin = end + 1;
    }
    const std::size_t digits = words.front().find_last_not_of("0123456789") + 1;
    if (digits != 0 && digits < words.front().size()) {
        words.insert(words.begin() + 1, words.front().substr(digits));
        words.front() = words.front().substr(0, digits);
    }
    const bool whole =
        std::any_of(words.begin(), words.end(), [](std::string_view word) { return word.empty(); });
    return whole ? std::vector{name} : words;
}

/// Returns a symbol. `w1`, `w_1` and `w[1]` are w with an index, `w1_max` and `w_max[1]` are w with
/// two, and `w1_dot` is w with an index and a dot. Indices in brackets come first, as digits do:
/// X_2[1], like X1_2, is the value of x_1 in stage 2.
std::string symbol_latex(std::string_view name) {
    if (name.find('{') != std::string_view::npos) return std::string(name);
    const std::size_t bracket = std::min(name.find('['), name.size());
    std::vector<std::string_view> words = words_of(name.substr(0, bracket));
    const auto dot = std::find(words.begin() + 1, words.end(), "dot");
    const bool is_velocity = dot != words.end();
    if (is_velocity) words.erase(dot);
    std::string indices;
    if (bracket < name.size()) indices = name.substr(bracket + 1, name.size() - bracket - 2);
    for (std::size_t k = 1; k < words.size(); ++k)
        indices += (indices.empty() ? "" : ",") + word_latex(words[k]);
    const std::string stem = word_latex(words.front());
    return (is_velocity ? "\\dot{" + stem + "}" : stem) +
           (indices.empty() ? "" : "_{" + indices + "}");
}

std::string call_latex(const Expression& call, const std::string& exponent = {}) {
    const Function* function = find_function(call.name);
    std::string text =
        function != nullptr ? std::string(function->latex) : "\\operatorname{" + call.name + "}";
    if (!exponent.empty()) text += "^{" + exponent + "}";
    std::string arguments;
    for (const Expression& argument : call.arguments)
        arguments += (arguments.empty() ? "" : ", ") + latex(argument, Bar::slash);
    return text + in_sized_parentheses(arguments);
}

/// Returns `x` where a < b, `y` elsewhere.
std::string if_latex(const Expression& call) {
    const auto argument = [&](std::size_t k) { return latex(call.arguments[k], Bar::slash); };
    const std::string sign = call.name == "if<" ? " < " : " \\le ";
    return "\\begin{cases}" + argument(2) + " & " + argument(0) + sign + argument(1) + " \\\\ " +
           argument(3) + " & \\text{otherwise}\\end{cases}";
}

std::string absolute_latex(const Expression& argument) {
    return "\\left|" + latex(argument, Bar::slash) + "\\right|";
}

std::string exponential_latex(const Expression& argument) {
    return "e^{" + latex(argument, Bar::slash) + "}";
}

/// Whether a call is written with its name.
bool has_name(const Expression& call) {
    return call.name != "exp" && call.name != "abs" && !is_if(call.name);
}

/// Returns a power. Only a squared sine has the exponent inside: \sin^{-1} would be taken for the
/// arc.
std::string power_latex(const Expression& base, const Expression& exponent) {
    const std::string raised = latex(exponent, Bar::slash);
    const bool root = base.kind == Expression::Kind::call && base.name == "sqrt";
    const bool function = base.kind == Expression::Kind::call && !root && has_name(base);
    const bool count = exponent.kind == Expression::Kind::number && exponent.denominator == "1";
    if (function && count) return call_latex(base, raised);
    const bool word = root || base.kind == Expression::Kind::symbol ||
                      base.kind == Expression::Kind::element ||
                      (base.kind == Expression::Kind::number && base.denominator == "1");
    const std::string text = latex(base, Bar::stacked);
    return (word ? text : in_sized_parentheses(text)) + "^{" + raised + "}";
}

/// Returns `x_{k-1}`; mod(k-2,N) is (k-2) \\bmod N.
std::string element_latex(const Expression& element) {
    const std::string name = symbol_latex(element.name);
    std::string indices;
    for (const Expression& index : element.arguments)
        indices += (indices.empty() ? "" : ",") + latex(index, Bar::slash);
    const std::size_t own = name.find("_{");
    return own == std::string::npos
               ? name + "_{" + indices + "}"
               : name.substr(0, own + 2) + indices + "," + name.substr(own + 2);
}

/// Returns (k-2) \bmod N.
std::string mod_latex(const Expression& call) {
    const std::string of = latex(call.arguments[0], Bar::slash);
    const bool is_sum = call.arguments[0].kind == Expression::Kind::sum;
    return in_sized_parentheses((is_sum ? in_sized_parentheses(of) : of) + " \\bmod " +
                                latex(call.arguments[1], Bar::slash));
}

std::string sum_over_latex(const Expression& sum) {
    const Expression& term = sum.arguments[2];
    const std::string text = latex(term, Bar::stacked);
    return "\\sum_{" + symbol_latex(sum.name) + "=" + latex(sum.arguments[0], Bar::slash) + "}^{" +
           latex(sum.arguments[1], Bar::slash) + "} " +
           (term.kind == Expression::Kind::sum || text.front() == '-' ? in_sized_parentheses(text)
                                                                      : text);
}

std::string factor_latex(const WrittenFactor& factor) {
    if (const auto* digits = std::get_if<std::string_view>(&factor)) return std::string(*digits);
    const Expression& expression = *std::get<const Expression*>(factor);
    switch (expression.kind) {
    case Expression::Kind::sum: return in_sized_parentheses(latex(expression, Bar::stacked));
    case Expression::Kind::power:
        return power_latex(expression.arguments[0], expression.arguments[1]);
    case Expression::Kind::call:
        if (expression.name == "sqrt")
            return "\\sqrt{" + latex(expression.arguments[0], Bar::stacked) + "}";
        if (expression.name == "exp") return exponential_latex(expression.arguments[0]);
        if (expression.name == "abs") return absolute_latex(expression.arguments[0]);
        if (is_if(expression.name)) return if_latex(expression);
        return expression.name == "mod" ? mod_latex(expression) : call_latex(expression);
    case Expression::Kind::element: return element_latex(expression);
    case Expression::Kind::sum_over: return in_sized_parentheses(sum_over_latex(expression));
    default: return symbol_latex(expression.name);
    }
}

/// Whether a text ends in a command like `\pi`, which a letter must not follow directly.
bool ends_in_command(const std::string& text) {
    std::size_t k = text.size();
    while (k > 0 && is_letter(text[k - 1])) --k;
    return k > 0 && k < text.size() && text[k - 1] == '\\';
}

/// Returns factors side by side, with a dot where two numbers would meet.
std::string factors_latex(const std::vector<WrittenFactor>& factors) {
    if (factors.empty()) return "1";
    std::string text;
    std::string last;
    for (const WrittenFactor& factor : factors) {
        const std::string next = factor_latex(factor);
        if (!last.empty() && is_digit(next.front()))
            text += " \\cdot ";
        else if (ends_in_command(last) && is_letter(next.front()))
            text += " ";
        text += next;
        last = next;
    }
    return text;
}

/// Returns factors above or below a bar, where a lone sum needs no parentheses.
std::string between_braces(const std::vector<WrittenFactor>& factors) {
    const Expression* lone_sum =
        factors.size() == 1 ? get_if_kind(factors[0], Expression::Kind::sum) : nullptr;
    return "{" + (lone_sum != nullptr ? latex(*lone_sum, Bar::stacked) : factors_latex(factors)) +
           "}";
}

/// Returns the fraction without its sign.
std::string fraction_latex(const Fraction& fraction, Bar bar) {
    if (fraction.is_simple() && !fraction.above.empty())
        if (const auto* sum = get_if_kind(fraction.above[0], Expression::Kind::sum_over))
            return sum_over_latex(*sum);
    if (fraction.below.empty()) return factors_latex(fraction.above);
    if (bar == Bar::stacked)
        return "\\frac" + between_braces(fraction.above) + between_braces(fraction.below);
    const std::string below = factors_latex(fraction.below);
    return factors_latex(fraction.above) + "/" +
           (fraction.below.size() == 1 ? below : in_sized_parentheses(below));
}

std::string sum_latex(const Expression& sum, Bar bar) {
    std::string text;
    for (const Expression& term : sum.arguments) {
        const Fraction fraction = as_fraction(term);
        if (text.empty())
            text += fraction.negative ? "-" : "";
        else
            text += fraction.negative ? " - " : " + ";
        text += fraction_latex(fraction, bar);
    }
    return text;
}

std::string latex(const Expression& expression, Bar bar) {
    if (expression.kind == Expression::Kind::sum) return sum_latex(expression, bar);
    const Fraction fraction = as_fraction(expression);
    return (fraction.negative ? "-" : "") + fraction_latex(fraction, bar);
}

}  // namespace

std::string to_latex(const Expression& expression) { return latex(expression, Bar::stacked); }

}  // namespace hvi::gen
