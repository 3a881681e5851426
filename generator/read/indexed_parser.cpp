// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/read/indexed_parser.hpp"

#include <fmt/format.h>

#include <utility>

#include "generator/read/names.hpp"

namespace hvi::gen {

Expression IndexedParser::name(const Token& name) {
    const std::string text_of_name = text(name.range);
    if (next_is(Kind::open) && text_of_name == "sum") return sum_over_indices(name);
    if (next_is(Kind::open) && text_of_name == "mod") return modulo(name);
    if (next_is(Kind::open_index)) return element(name);
    if (indices_of_sums_.count(text_of_name) != 0)
        return located(Expression::symbol(text_of_name), name.range.begin);
    return ExpressionParser::name(name);
}

/// Reads an index, or a bound of one. `mod` may stand in these only.
Expression IndexedParser::index() {
    ++indices_deep_;
    Expression written = sum();
    --indices_deep_;
    return written;
}

Expression IndexedParser::modulo(const Token& name) {
    if (indices_deep_ == 0)
        fail(name.range, "`mod` stands in indices alone", "as in `x[mod(i+1, N)]`");
    take();
    std::vector<Expression> arguments{index()};
    take(Kind::comma, "`mod` takes two arguments: as in `mod(i+1, N)`");
    arguments.push_back(index());
    take(Kind::close, "`)` is wanted here: `mod` takes two arguments");
    return located(Expression::call("mod", std::move(arguments)), name.range.begin);
}

/// Takes the `]` that ends the indices of a name. A second list of indices cannot follow.
void IndexedParser::take_close_index() {
    take(Kind::close_index, "`]` is wanted here");
    if (next_is(Kind::open_index))
        fail(next().range, "indices stand in one pair of brackets", "as in `K[i,j]`");
}

Expression IndexedParser::element(const Token& name) {
    take();
    std::vector<Expression> indices{index()};
    while (next_is(Kind::comma)) {
        take();
        indices.push_back(index());
    }
    take_close_index();
    return located(Expression::element(text(name.range), std::move(indices)), name.range.begin);
}

/// Reads the i of `sum(i=`.
std::string IndexedParser::index_name() {
    constexpr std::size_t most_indices = 16;
    const Token token = take(Kind::name, "the index of the sum is wanted here");
    if (indices_of_sums_.size() == most_indices)
        fail(token.range, fmt::format("there are more than {} indices here", most_indices));
    std::string name = text(token.range);
    check_parameter_name(name, place(token.range), "an index");
    if (is_own(name)) fail(token.range, fmt::format("`{}` is a function of [functions]", name));
    if (indices_of_sums_.count(name) != 0)
        fail(token.range, fmt::format("`{}` is the index of a sum around this one", name),
             "take another letter");
    return name;
}

Expression IndexedParser::sum_over_indices(const Token& name) {
    const Token open = take();
    Expression sum = one_sum(name);
    take_close(open);
    return located(std::move(sum), name.range.begin);
}

/// Whether `j=` follows.
bool IndexedParser::is_next_index() const {
    return next_is(Kind::name) && next_is_followed_by(Kind::equals);
}

/// Reads `i=1..3, ` and the rest of the sum: another index, or the term.
Expression IndexedParser::one_sum(const Token& name) {
    std::string index_of_sum = index_name();
    take(Kind::equals, "`=` is wanted here");
    Expression first = index();
    take(Kind::to, "`..` is wanted here, as in `sum(i=1..3, x[i])`");
    Expression last = index();
    if (!next_is(Kind::comma))
        fail(next().range, "a comma and the term of the sum are wanted here");
    take();
    indices_of_sums_.insert(index_of_sum);
    Expression term = is_next_index() ? one_sum(name) : sum();
    indices_of_sums_.erase(index_of_sum);
    return located(Expression::sum_over(std::move(index_of_sum), std::move(first), std::move(last),
                                        std::move(term)),
                   name.range.begin);
}

std::vector<Name> IndexedParser::names() {
    std::vector<Name> names{one_name()};
    while (next_is(Kind::comma)) {
        take();
        names.push_back(one_name());
    }
    if (!next_is(Kind::end)) fail(next().range, "names are separated by commas");
    return names;
}

/// Reads `3`, or `1..3`.
IndexBounds IndexedParser::bounds() {
    const std::size_t begin = next().range.begin;
    Expression first = index();
    Expression last = first;
    if (next_is(Kind::to)) {
        take();
        last = index();
    } else if (!next_is(Kind::comma) && !next_is(Kind::close_index)) {
        fail(next().range, "`..` is wanted here, as in `x[1..3]`");
    }
    return {std::move(first), std::move(last), {begin, previous().range.end}};
}

/// Reads `x`, `x[1]`, `x[1..3]`, or `u[1..3,1..4]`.
Name IndexedParser::one_name() {
    const Token token = take(Kind::name, "a name is wanted here");
    Name name{text(token.range), {}, token.range};
    if (!next_is(Kind::open_index)) return name;
    do {
        take();
        name.bounds.push_back(bounds());
    } while (next_is(Kind::comma));
    take_close_index();
    name.range.end = previous().range.end;
    return name;
}

/// Reads `x`, `x[i]`, or `u[i,j]`, where the indices are names.
RuleName IndexedParser::rule_name() {
    RuleName name{text(take(Kind::name, "a name is wanted here").range), {}};
    if (next_is(Kind::open_index)) {
        do {
            take();
            const std::string index = index_name();
            indices_of_sums_.insert(index);
            name.indices.push_back(index);
        } while (next_is(Kind::comma));
        take_close_index();
    }
    if (!next_is(Kind::end)) fail(next().range, "one name is wanted here");
    return name;
}

}  // namespace hvi::gen
