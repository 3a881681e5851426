// Our own reader of mathematical expressions, and of lists of them.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "generator/expr/expression.hpp"
#include "generator/expr/own_functions.hpp"

namespace hvi::gen {

/// A family with its size: `gauss:3`. The caller decides which names and sizes exist.
struct Family {
    std::string name;
    long size = 0;  ///< not negative; the largest long for a larger number
    Range range;
};

/// One item of a list.
struct Item {
    std::variant<Expression, Family> what;
    Range range;
};

/// A list as the user gave it. The ranges in its items are ranges in `source`.
struct List {
    std::shared_ptr<const Source> source;
    std::vector<Item> items;

    [[nodiscard]] Place place(Range range) const { return {source, range}; }
};

/// Reads one expression:
///
///     sum     = product (("+" | "-") product)*
///     product = signed (("*" | "/") signed)*
///     signed  = ("+" | "-") signed | power
///     power   = operand ("^" signed)?               so that -x^2 is -(x^2), and 2^-3 is read
///     operand = number | name | name "(" sum ("," sum)* ")" | "(" sum ")"
///
/// A decimal means exactly what is written. Names of functions are those of expr/functions.hpp; any
/// other name is a symbol. Throws InputError, with its place, for any other text, for one of more
/// than 64 KiB, and for one nested deeper than 200.
[[nodiscard]] Expression parse_expression(std::shared_ptr<const Source> source);

/// Reads an expression that is a part of a source. Precondition: `part` lies within the text.
[[nodiscard]] Expression parse_expression(std::shared_ptr<const Source> source, Range part);

/// An expression as it was written, in which names can have indices and sums run over them; see
/// Expression::Kind. unrolled() turns it into an expression of plain symbols.
struct IndexedExpression {
    Expression written;
    std::shared_ptr<const Source> source;  ///< the ranges in `written` are ranges there
};

/// Reads one expression in which names can have indices and sums can run over them:
///
///     operand = ... | name "[" index ("," index)* "]"
///             | "sum" "(" name "=" index ".." index ("," name "=" index ".." index)* "," sum ")"
///     index   = a sum, in which an operand can be "mod" "(" index "," index ")" too
///
/// `own` are the user's own functions that it may call. Throws as `parse_expression` does.
[[nodiscard]] IndexedExpression parse_indexed_expression(std::shared_ptr<const Source> source,
                                                         const OwnArguments& own = {});

/// Reads an expression that is a part of a source. Precondition: `part` lies within the text.
[[nodiscard]] IndexedExpression parse_indexed_expression(std::shared_ptr<const Source> source,
                                                         Range part, const OwnArguments& own = {});

/// The first and the last value of an index. A single value is both.
struct IndexBounds {
    Expression first, last;
    Range range;
};

/// A name in a list of names, with the bounds of its indices; without an index, `bounds` is empty.
struct Name {
    std::string stem;
    std::vector<IndexBounds> bounds;
    Range range;
};

/// Reads a list of at least one name, separated by commas: `x, y[1..3], z[7], u[1..N,0..2]`. Throws
/// InputError for any other text.
[[nodiscard]] std::vector<Name> parse_names(std::shared_ptr<const Source> source);

/// Reads a list of names that is a part of a source. Precondition: `part` lies within the text.
[[nodiscard]] std::vector<Name> parse_names(std::shared_ptr<const Source> source, Range part);

/// A name whose indices have names: `u[i,j]`.
struct RuleName {
    std::string stem;
    std::vector<std::string> indices;
};

/// Reads one such name, with indices or without, from a part of a source. Throws InputError for any
/// other text.
[[nodiscard]] RuleName parse_rule_name(std::shared_ptr<const Source> source, Range part);

/// Reads a list of at least one item, separated by commas. An item is an expression, or a family
/// with its size: a word of letters, digits and dashes, a colon, and a whole number. Throws as
/// `parse_expression` does.
[[nodiscard]] List parse_list(std::shared_ptr<const Source> source);

/// Reads a family with its size that stands alone. Throws InputError for any other text.
[[nodiscard]] Family parse_family(std::shared_ptr<const Source> source);

}  // namespace hvi::gen
