// Expressions as plain data: what the reader makes of a text, and what closed forms are written in.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "generator/support/error.hpp"

namespace hvi::gen {

/// A mathematical expression. Sums and products are flat, a difference is a sum with a negation in
/// it and a quotient a product with a reciprocal in it, so that a long text does not make a deep
/// tree. Invariants: `number` has digits in `numerator` and `denominator` (no sign, denominator not
/// zero, lowest terms not required), and in `name` what it is written as where that is a decimal;
/// `symbol` and `call` have a `name`; `sum` and `product` have at least two arguments; `negation`
/// and `reciprocal` have one; `power` has two (base, exponent); `call` has one or more. What a
/// reader of indices returns has besides `element`, a name with its indices as arguments, and
/// `sum_over`, an index with a name and three arguments (first, last, term); unrolled() leaves none
/// of them, and what is said of expressions elsewhere is said of those without.
struct Expression {
    enum class Kind {
        number,
        symbol,
        sum,
        product,
        negation,
        reciprocal,
        power,
        call,
        element,
        sum_over
    };

    Kind kind = Kind::number;
    std::string name;  ///< symbol, call, element, index of sum_over; of a number, see above
    std::string numerator = "0";    ///< number
    std::string denominator = "1";  ///< number
    std::vector<Expression> arguments;
    Range range;  ///< where it stands in the text it was read from

    [[nodiscard]] static Expression integer(long value);  ///< a negation when value < 0
    [[nodiscard]] static Expression rational(std::string numerator, std::string denominator);
    /// A number that is to be written as a decimal: `0.25`, `-1.5e-20` (a product with a power of
    /// ten).
    [[nodiscard]] static Expression decimal(std::string_view text);
    [[nodiscard]] static Expression symbol(std::string name);
    /// Of no term it is 0, of one the term itself; sums among the terms are flattened.
    [[nodiscard]] static Expression sum(std::vector<Expression> terms);
    /// Of no factor it is 1, of one the factor itself; products among the factors are flattened.
    [[nodiscard]] static Expression product(std::vector<Expression> factors);
    [[nodiscard]] static Expression negation(Expression argument);
    [[nodiscard]] static Expression reciprocal(Expression argument);
    [[nodiscard]] static Expression power(Expression base, Expression exponent);
    [[nodiscard]] static Expression call(std::string function, std::vector<Expression> arguments);
    [[nodiscard]] static Expression element(std::string name, std::vector<Expression> indices);
    [[nodiscard]] static Expression sum_over(std::string index, Expression first, Expression last,
                                             Expression term);
};

/// Same tree, whatever the ranges.
[[nodiscard]] bool operator==(const Expression& left, const Expression& right);

/// A total order of expressions, whatever the ranges: by their numbers and names in the order in
/// which they are written, numbers before names, then by what is made of them.
[[nodiscard]] bool precedes(const Expression& left, const Expression& right);

/// How many numbers, names and operations it is made of.
[[nodiscard]] std::size_t word_count(const Expression& expression);

/// The expression as the reader of `generator/read` takes it: no blanks, parentheses only where
/// precedence asks for them. `1/6-5*sqrt(2)/48`, `(pi-2)/(2*pi)`, `cos(2*pi*tau)`.
[[nodiscard]] std::string to_text(const Expression& expression);

/// The expression with other arguments, in its place: sums and products are flattened, as sum() and
/// product() make them.
[[nodiscard]] Expression with_arguments(Expression expression, std::vector<Expression> arguments);

/// The expression with other names for its symbols; those that are no key keep theirs.
[[nodiscard]] Expression renamed(const Expression& expression,
                                 const std::map<std::string, std::string>& names);

/// Whether a sum over an index stands in it.
[[nodiscard]] bool has_sum(const Expression& expression);

/// The expression with others in the places of its symbols; those that are no key stay, and so do
/// indices within their sums.
[[nodiscard]] Expression replaced(const Expression& expression,
                                  const std::map<std::string, Expression>& by);

/// The expression in LaTeX's mathematics: `\frac{\pi - 2}{2\pi}`, `\sin\left(w/3\right)`. Names of
/// Greek letters become these letters, `w_1`, `w1` and `w[1]` an indexed w, `w1_max` one with two
/// indices, and `w_dot` a w with a dot. A name with a brace in it is LaTeX already.
[[nodiscard]] std::string to_latex(const Expression& expression);

}  // namespace hvi::gen
