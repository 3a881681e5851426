// Writes expressions as text that the reader takes back.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cstddef>
#include <variant>

#include "generator/expr/fraction.hpp"
#include "generator/expr/functions.hpp"

namespace hvi::gen {

namespace {

std::string parenthesised(const std::string& text) { return "(" + text + ")"; }

/// Whether the fraction is written as `2`, `x`, `x[1]` or `sin(x)`.
bool is_word(const Fraction& fraction) {
    if (fraction.negative || !fraction.is_simple()) return false;
    if (fraction.above.empty()) return true;
    const WrittenFactor& factor = fraction.above.front();
    return std::holds_alternative<std::string_view>(factor) ||
           get_if_kind(factor, Expression::Kind::symbol) != nullptr ||
           get_if_kind(factor, Expression::Kind::element) != nullptr ||
           get_if_kind(factor, Expression::Kind::sum_over) != nullptr ||
           get_if_kind(factor, Expression::Kind::call) != nullptr;
}

/// Returns the sum that the fraction is, like `1*(a+b)`, which needs no parentheses; or null.
const Expression* lone_sum(const Fraction& fraction) {
    const bool lone = !fraction.negative && fraction.below.empty() && fraction.above.size() == 1;
    return lone ? get_if_kind(fraction.above.front(), Expression::Kind::sum) : nullptr;
}

/// Returns a base: a single word, or else in parentheses.
std::string base_text(const Expression& base) {
    return is_word(as_fraction(base)) ? to_text(base) : parenthesised(to_text(base));
}

/// Returns an exponent. `^` binds to the right and takes a sign, so that `2^-x^2` needs no
/// parentheses.
std::string exponent_text(const Expression& exponent) {
    const Fraction fraction = as_fraction(exponent);
    const bool simple = fraction.is_simple() && lone_sum(fraction) == nullptr;
    return simple ? to_text(exponent) : parenthesised(to_text(exponent));
}

/// Returns `if(a<b,x,y)`.
std::string if_text(const Expression& call) {
    const auto argument = [&](std::size_t k) { return to_text(call.arguments[k]); };
    return "if(" + argument(0) + call.name.substr(2) + argument(1) + "," + argument(2) + "," +
           argument(3) + ")";
}

std::string call_text(const Expression& call) {
    if (is_if(call.name)) return if_text(call);
    std::string text = call.name + "(";
    for (std::size_t k = 0; k < call.arguments.size(); ++k)
        text += (k == 0 ? "" : ",") + to_text(call.arguments[k]);
    return text + ")";
}

/// Returns `x[i+1]`, or with several indices `u[i,j]`.
std::string element_text(const Expression& element) {
    std::string text = element.name + "[";
    for (std::size_t k = 0; k < element.arguments.size(); ++k)
        text += (k == 0 ? "" : ",") + to_text(element.arguments[k]);
    return text + "]";
}

std::string sum_over_text(const Expression& sum) {
    return "sum(" + sum.name + "=" + to_text(sum.arguments[0]) + ".." + to_text(sum.arguments[1]) +
           "," + to_text(sum.arguments[2]) + ")";
}

std::string factor_text(const WrittenFactor& factor) {
    if (const auto* digits = std::get_if<std::string_view>(&factor)) return std::string(*digits);
    const Expression& expression = *std::get<const Expression*>(factor);
    switch (expression.kind) {
    case Expression::Kind::sum: return parenthesised(to_text(expression));
    case Expression::Kind::call: return call_text(expression);
    case Expression::Kind::element: return element_text(expression);
    case Expression::Kind::sum_over: return sum_over_text(expression);
    case Expression::Kind::power:
        return base_text(expression.arguments[0]) + "^" + exponent_text(expression.arguments[1]);
    default: return expression.name;
    }
}

std::string factors_text(const std::vector<WrittenFactor>& factors) {
    if (factors.empty()) return "1";
    std::string text;
    for (const WrittenFactor& factor : factors)
        text += (text.empty() ? "" : "*") + factor_text(factor);
    return text;
}

/// Returns the fraction without its sign.
std::string fraction_text(const Fraction& fraction) {
    const std::string above = factors_text(fraction.above);
    if (fraction.below.empty()) return above;
    const std::string below = factors_text(fraction.below);
    return above + "/" + (fraction.below.size() == 1 ? below : parenthesised(below));
}

std::string sum_text(const Expression& sum) {
    std::string text;
    for (const Expression& term : sum.arguments) {
        const std::string next = to_text(term);
        if (!text.empty() && next.front() != '-') text += "+";
        text += next;
    }
    return text;
}

}  // namespace

std::string to_text(const Expression& expression) {
    if (expression.kind == Expression::Kind::sum) return sum_text(expression);
    const Fraction fraction = as_fraction(expression);
    if (const Expression* sum = lone_sum(fraction)) return sum_text(*sum);
    return (fraction.negative ? "-" : "") + fraction_text(fraction);
}

}  // namespace hvi::gen
