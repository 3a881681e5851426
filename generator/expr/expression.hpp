// Expressions as plain data, for texts that are read and for closed forms.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "generator/support/error.hpp"

namespace hvi::gen {

/// A mathematical expression. Sums and products are flat. A difference is a sum with a negation in
/// it, and a quotient a product with a reciprocal in it, so that a long text does not make a deep
/// tree. Invariants: `number` has digits in `numerator` and `denominator` (no sign, denominator not
/// zero, lowest terms not required), and in `name` its text if it is written as a decimal; `symbol`
/// and `call` have a `name`; `sum` and `product` have at least two arguments; `negation` and
/// `reciprocal` have one; `power` has two (base, exponent); `call` has one or more. A reader of
/// indices also returns `element`, a name with its indices as arguments, and `sum_over`, an index
/// with a name and three arguments (first, last, term). unrolled() leaves none of these, and other
/// comments on expressions assume expressions without them.
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
    Range range;  ///< the place in the text it was read from

    [[nodiscard]] static Expression integer(long value);  ///< a negation when value < 0
    [[nodiscard]] static Expression rational(std::string numerator, std::string denominator);
    /// Makes a number that is to be written as a decimal: `0.25`, `-1.5e-20` (a product with a
    /// power of ten).
    [[nodiscard]] static Expression decimal(std::string_view text);
    [[nodiscard]] static Expression symbol(std::string name);
    /// Makes a sum: 0 without terms, the term itself for one. Sums among the terms are flattened.
    [[nodiscard]] static Expression sum(std::vector<Expression> terms);
    /// Makes a product: 1 without factors, the factor itself for one. Products among the factors
    /// are flattened.
    [[nodiscard]] static Expression product(std::vector<Expression> factors);
    [[nodiscard]] static Expression negation(Expression argument);
    [[nodiscard]] static Expression reciprocal(Expression argument);
    [[nodiscard]] static Expression power(Expression base, Expression exponent);
    [[nodiscard]] static Expression call(std::string function, std::vector<Expression> arguments);
    [[nodiscard]] static Expression element(std::string name, std::vector<Expression> indices);
    [[nodiscard]] static Expression sum_over(std::string index, Expression first, Expression last,
                                             Expression term);
};

/// Compares trees without their ranges.
[[nodiscard]] bool operator==(const Expression& left, const Expression& right);

/// A total order of expressions that ignores ranges: by their numbers and names in the order of
/// writing, numbers before names, then by their operations.
[[nodiscard]] bool precedes(const Expression& left, const Expression& right);

/// Counts the numbers, names and operations.
[[nodiscard]] std::size_t word_count(const Expression& expression);

/// Returns text that the reader of `generator/read` takes: no blanks, parentheses only where
/// precedence asks for them. `1/6-5*sqrt(2)/48`, `(pi-2)/(2*pi)`, `cos(2*pi*tau)`.
[[nodiscard]] std::string to_text(const Expression& expression);

/// Returns the expression with other arguments, in its place. Sums and products are flattened, as
/// sum() and product() do.
[[nodiscard]] Expression with_arguments(Expression expression, std::vector<Expression> arguments);

/// Renames symbols; those that are no key keep their names.
[[nodiscard]] Expression renamed(const Expression& expression,
                                 const std::map<std::string, std::string>& names);

/// Whether the expression contains a sum over an index.
[[nodiscard]] bool has_sum(const Expression& expression);

/// Replaces symbols by expressions; those that are no key stay, and so do indices within their
/// sums.
[[nodiscard]] Expression replaced(const Expression& expression,
                                  const std::map<std::string, Expression>& by);

/// Returns the expression in LaTeX's mathematics: `\frac{\pi - 2}{2\pi}`, `\sin\left(w/3\right)`.
/// Names of Greek letters become these letters, `w_1`, `w1` and `w[1]` an indexed w, `w1_max` one
/// with two indices, and `w_dot` a w with a dot. A name with a brace in it is LaTeX already.
[[nodiscard]] std::string to_latex(const Expression& expression);

}  // namespace hvi::gen
