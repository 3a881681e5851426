// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/read/indexed_parser.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "generator/read/names.hpp"

namespace hvi::gen {

namespace {

constexpr std::size_t most_names = 1000;

/// Of an expression made of whole numbers below a million, +, - and *.
std::optional<long> whole_value(const Expression& expression) {
    constexpr long largest = 1'000'000;
    using ExpressionKind = Expression::Kind;
    long value = 0;
    if (expression.kind == ExpressionKind::number) {
        if (expression.denominator != "1" || expression.numerator.size() > 7) return {};
        value = std::stol(expression.numerator);
    } else if (expression.kind == ExpressionKind::negation) {
        const auto argument = whole_value(expression.arguments.front());
        return argument ? std::optional(-*argument) : std::nullopt;
    } else if (expression.kind == ExpressionKind::sum ||
               expression.kind == ExpressionKind::product) {
        const bool is_sum = expression.kind == ExpressionKind::sum;
        value = is_sum ? 0 : 1;
        for (const Expression& part : expression.arguments) {
            const auto next = whole_value(part);
            if (!next) return {};
            value = is_sum ? value + *next : value * *next;
            if (value > largest || value < -largest) return {};
        }
    } else {
        return {};
    }
    return value <= largest ? std::optional(value) : std::nullopt;
}

}  // namespace

Expression IndexedParser::name(const Token& name) {
    const std::string text_of_name = text(name.range);
    if (next_is(Kind::open) && text_of_name == "sum") return sum_over_index(name);
    if (next_is(Kind::open_index)) return indexed_name(name);
    const auto index = indices_of_sums_.find(text_of_name);
    if (index != indices_of_sums_.end())
        return located(Expression::integer(index->second), name.range.begin);
    return ExpressionParser::name(name);
}

/// The value of what is written at this place.
long IndexedParser::whole_number() { return whole_number(sum()); }

long IndexedParser::whole_number(const Expression& expression) const {
    const std::optional<long> value = whole_value(expression);
    if (!value)
        fail(expression.range, "a whole number is wanted here",
             "it is made of numbers, +, - and *, and of the index of a sum around it");
    return *value;
}

/// The end of an index, behind which there is no other.
void IndexedParser::take_close_index() {
    constexpr const char* one_for_two =
        "names with several are to come: put two into one, as in `K[3*(i-1)+j]`";
    if (next_is(Kind::comma)) fail(next().range, "a name has one index", one_for_two);
    take(Kind::close_index, "`]` is wanted here");
    if (next_is(Kind::open_index)) fail(next().range, "a name has one index", one_for_two);
}

Expression IndexedParser::indexed_name(const Token& name) {
    take();
    const Expression written = sum();
    take_close_index();
    const long index = whole_number(written);
    return located(Expression::symbol(fmt::format("{}[{}]", text(name.range), index)),
                   name.range.begin);
}

/// The i of `sum(i=`.
std::string IndexedParser::index_of_sum() {
    const Token token = take(Kind::name, "the index of the sum is wanted here");
    std::string name = text(token.range);
    check_parameter_name(name, place(token.range));
    if (indices_of_sums_.count(name) != 0)
        fail(token.range, fmt::format("`{}` is the index of a sum around this one", name),
             "take another letter");
    take(Kind::equals, "`=` is wanted here");
    return name;
}

/// NOTE: the text of the terms is read once for each value of the index.
Expression IndexedParser::sum_over_index(const Token& name) {
    const Token open = take();
    const std::string index = index_of_sum();
    const long first = whole_number();
    take(Kind::to, "`..` is wanted here, as in `sum(i=1..3, x[i])`");
    const long last = whole_number();
    if (first > last) fail({open.range.end, previous().range.end}, "this sum has no term");
    if (!next_is(Kind::comma))
        fail(next().range, "a comma and the term of the sum are wanted here");
    const Token comma = next();
    std::vector<Expression> terms;
    for (long value = first; value <= last; ++value) {
        take_elsewhere(comma);
        indices_of_sums_[index] = value;
        terms.push_back(sum());
    }
    indices_of_sums_.erase(index);
    take_close(open);
    return located(Expression::sum(std::move(terms)), name.range.begin);
}

std::vector<Name> IndexedParser::names() {
    std::vector<Name> names;
    append_names(names);
    while (next_is(Kind::comma)) {
        take();
        append_names(names);
    }
    if (!next_is(Kind::end)) fail(next().range, "names are separated by commas");
    return names;
}

/// `x`, `x[1]`, or `x[1..3]`.
void IndexedParser::append_names(std::vector<Name>& names) {
    const Token token = take(Kind::name, "a name is wanted here");
    const std::string name = text(token.range);
    if (!next_is(Kind::open_index)) {
        names.push_back({name, token.range});
        return;
    }
    take();
    const long first = whole_number();
    long last = first;
    if (!next_is(Kind::close_index)) {
        take(Kind::to, "`..` is wanted here, as in `x[1..3]`");
        last = whole_number();
    }
    take_close_index();
    const Range range{token.range.begin, previous().range.end};
    if (first > last) fail(range, "there is no such index");
    if (static_cast<std::size_t>(last - first) >= most_names - names.size())
        fail(range, fmt::format("there are more than {} names", most_names));
    for (long index = first; index <= last; ++index)
        names.push_back({fmt::format("{}[{}]", name, index), range});
}

}  // namespace hvi::gen
