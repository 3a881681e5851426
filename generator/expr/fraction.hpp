// The written form of a product: a sign, a numerator, and a denominator.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string_view>
#include <variant>
#include <vector>

#include "generator/expr/expression.hpp"

namespace hvi::gen {

/// An integer or a decimal by its digits, or a sum, symbol, power or call.
using WrittenFactor = std::variant<std::string_view, const Expression*>;

/// Sign and factors of an expression; factors of 1 are left out, so that no factor means 1.
struct Fraction {
    bool negative = false;
    std::vector<WrittenFactor> above;
    std::vector<WrittenFactor> below;

    /// Whether it is a single factor, or 1, which needs no parentheses as an exponent.
    [[nodiscard]] bool is_simple() const { return below.empty() && above.size() <= 1; }
};

/// Takes products, quotients, negations and rationals apart; order is kept. The result refers to
/// `expression`, which must outlive it.
[[nodiscard]] Fraction as_fraction(const Expression& expression);

/// Returns the expression when the factor is one of the given kind, else null.
[[nodiscard]] const Expression* get_if_kind(const WrittenFactor& factor, Expression::Kind kind);

}  // namespace hvi::gen
