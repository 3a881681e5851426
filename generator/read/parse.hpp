// Our own reader of mathematical expressions, and of lists of them.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "generator/expr/expression.hpp"

namespace hvi::gen {

/// A family with its size: `gauss:3`. Which names and sizes there are is decided by who uses it.
struct Family {
    std::string name;
    long size = 0;  ///< not negative; the largest long for one that is larger still
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

/// The same for a part of a source. Precondition: `part` lies within the text.
[[nodiscard]] Expression parse_expression(std::shared_ptr<const Source> source, Range part);

/// Reads one expression in which names can have indices and sums can run over them:
///
///     operand = ... | name "[" sum "]" | "sum" "(" name "=" sum ".." sum "," sum ")"
///
/// They are expanded: `sum(i=1..2, x[i]^2)` is x[1]^2 + x[2]^2, of symbols with the names `x[1]`
/// and `x[2]`. Bounds and indices are whole numbers made of numbers and of the i of sums around
/// them. Throws as `parse_expression` does, and for what expands to more than 100 000 words.
[[nodiscard]] Expression parse_indexed_expression(std::shared_ptr<const Source> source);

/// A name in a list of names.
struct Name {
    std::string text;
    Range range;
};

/// Reads a list of at least one name, separated by commas: `x, y[1..3], z[7]` for x, y[1], y[2],
/// y[3], z[7].
/// Throws InputError for any other text, and for more than 1000 names.
[[nodiscard]] std::vector<Name> parse_names(std::shared_ptr<const Source> source);

/// Reads a list of at least one item, separated by commas. An item is an expression, or a family
/// with its size: a word of letters, digits and dashes, a colon, and a whole number. Throws as
/// `parse_expression` does.
[[nodiscard]] List parse_list(std::shared_ptr<const Source> source);

/// Reads a family with its size that stands alone. Throws InputError for any other text.
[[nodiscard]] Family parse_family(std::shared_ptr<const Source> source);

}  // namespace hvi::gen
