// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/expr/powers.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace hvi::gen {

namespace {

struct BaseAndExponent {
    Expression base;
    long exponent = 1;
};

/// Returns whole exponents from 2 to 99, so that their sums are small.
std::optional<long> small_exponent(const Expression& exponent) {
    const bool is_small = exponent.kind == Expression::Kind::number && exponent.name.empty() &&
                          exponent.denominator == "1" && exponent.numerator.size() <= 2;
    return is_small ? std::optional(std::stol(exponent.numerator)) : std::nullopt;
}

BaseAndExponent parts_of(Expression factor) {
    if (factor.kind != Expression::Kind::power) { return {std::move(factor)}; }
    const auto exponent = small_exponent(factor.arguments[1]);
    if (!exponent) { return {std::move(factor)}; }
    return {std::move(factor.arguments[0]), *exponent};
}

}  // namespace

Expression with_powers(Expression expression) {
    for (Expression& argument : expression.arguments) {
        argument = with_powers(std::move(argument));
    }
    if (expression.kind != Expression::Kind::product) { return expression; }
    std::vector<BaseAndExponent> all;
    for (Expression& argument : expression.arguments) {
        BaseAndExponent factor = parts_of(std::move(argument));
        const auto same = std::find_if(all.begin(), all.end(), [&](const BaseAndExponent& other) {
            return other.base == factor.base && factor.base.kind != Expression::Kind::number;
        });
        if (same == all.end()) {
            all.push_back(std::move(factor));
        } else {
            same->exponent += factor.exponent;
        }
    }
    std::vector<Expression> factors;
    for (BaseAndExponent& factor : all) {
        factors.push_back(
            factor.exponent == 1
                ? std::move(factor.base)
                : Expression::power(std::move(factor.base), Expression::integer(factor.exponent)));
    }
    return Expression::product(std::move(factors));
}

}  // namespace hvi::gen
