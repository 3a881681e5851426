// Splits a product into numerator and denominator.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/expr/fraction.hpp"

#include <utility>

namespace hvi::gen {

namespace {

void collect(const Expression& expression, bool inverted, Fraction& fraction) {
    std::vector<WrittenFactor>& here = inverted ? fraction.below : fraction.above;
    std::vector<WrittenFactor>& there = inverted ? fraction.above : fraction.below;
    switch (expression.kind) {
    case Expression::Kind::number:
        if (!expression.name.empty()) {
            here.emplace_back(std::string_view(expression.name));
            break;
        }
        if (expression.numerator != "1") here.emplace_back(std::string_view(expression.numerator));
        if (expression.denominator != "1")
            there.emplace_back(std::string_view(expression.denominator));
        break;
    case Expression::Kind::product:
        for (const Expression& factor : expression.arguments) collect(factor, inverted, fraction);
        break;
    case Expression::Kind::negation:
        fraction.negative = !fraction.negative;
        collect(expression.arguments[0], inverted, fraction);
        break;
    case Expression::Kind::reciprocal: collect(expression.arguments[0], !inverted, fraction); break;
    case Expression::Kind::symbol:
    case Expression::Kind::sum:
    case Expression::Kind::power:
    case Expression::Kind::call:
    case Expression::Kind::element:
    case Expression::Kind::sum_over: here.emplace_back(&expression); break;
    }
}

}  // namespace

Fraction as_fraction(const Expression& expression) {
    Fraction fraction;
    collect(expression, false, fraction);
    return fraction;
}

const Expression* get_if_kind(const WrittenFactor& factor, Expression::Kind kind) {
    const auto* expression = std::get_if<const Expression*>(&factor);
    return expression != nullptr && (*expression)->kind == kind ? *expression : nullptr;
}

}  // namespace hvi::gen
