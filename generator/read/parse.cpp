// A recursive-descent reader; each function reads one line of the grammar in parse.hpp.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/read/parse.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "generator/expr/functions.hpp"
#include "generator/read/decimal.hpp"
#include "generator/read/names.hpp"
#include "generator/read/nearest.hpp"
#include "generator/read/token.hpp"

namespace hvi::gen {

namespace {

using Kind = Token::Kind;

constexpr std::size_t longest_text = 64 * 1024;
constexpr int deepest_nesting = 200;
constexpr std::size_t most_words = 100'000;
constexpr std::size_t most_names = 1000;

Range whole(const Source& source) { return {0, source.text.size()}; }

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

class Parser {
public:
    Parser(std::shared_ptr<const Source> source, Range part, Indices indices = Indices::refused);

    Expression lone_expression();
    std::vector<Item> items();
    std::vector<Name> names();

private:
    Item item();
    std::optional<Family> family();

    Expression sum();
    Expression product();
    Expression signed_operand();
    Expression power();
    Expression operand();
    Expression number();
    Expression name();
    Expression call(const Token& name);
    Expression parenthesised();
    Expression indexed_name(const Token& name);
    Expression sum_over_index(const Token& name);
    std::string index_of_sum();
    long whole_number();
    void append_names(std::vector<Name>& names);

    Token take();
    Token take(Kind kind, const char* what);
    void take_close(const Token& open);
    Expression located(Expression expression, std::size_t begin) const;

    [[noreturn]] void fail(Range range, std::string what, std::string help = {}) const;
    [[noreturn]] void fail_missing_operand() const;
    [[noreturn]] void fail_missing_operator() const;
    [[noreturn]] void fail_unknown_function(const Token& name) const;
    void check_argument_count(const Expression& call, const Function& function) const;

    Lexer lexer_;
    Token next_;      ///< not yet taken
    Token previous_;  ///< taken last
    int nesting_ = 0;
    std::size_t words_ = 0;  ///< taken so far
    Indices indices_;
    std::map<std::string, long> indices_of_sums_;
};

Parser::Parser(std::shared_ptr<const Source> source, Range part, Indices indices)
    : lexer_(std::move(source), part, indices), indices_(indices) {
    if (part.end - part.begin > longest_text)
        fail({part.begin, part.begin}, "the text is longer than 64 KiB");
    next_ = lexer_.next();
    previous_ = {Kind::end, {part.begin, part.begin}};
    if (next_.is(Kind::end)) fail(part, "the text is empty");
}

Expression Parser::lone_expression() {
    Expression expression = sum();
    if (next_.is(Kind::comma))
        fail(next_.range, "one expression is wanted here, not a list",
             "a decimal number has a point: `0.5`");
    if (next_.is(Kind::close)) fail(next_.range, "there is no `(` for this `)`");
    if (!next_.is(Kind::end))
        fail(next_.range, fmt::format("`{}` cannot stand here", lexer_.text(next_.range)));
    return expression;
}

std::vector<Item> Parser::items() {
    std::vector<Item> items;
    do {
        if (!items.empty()) take();
        if (next_.is(Kind::comma)) fail(next_.range, "an item is missing before this comma");
        if (next_.is(Kind::end)) fail(previous_.range, "an item is missing after this comma");
        items.push_back(item());
    } while (next_.is(Kind::comma));
    if (next_.is(Kind::close)) fail(next_.range, "there is no `(` for this `)`");
    return items;
}

Item Parser::item() {
    if (std::optional<Family> found = family()) {
        const Range range = found->range;
        return {std::move(*found), range};
    }
    Expression expression = sum();
    const Range range = expression.range;
    return {std::move(expression), range};
}

/// A word with dashes is one only when a colon follows: `radau-left:2`, but `a-b` is a difference.
std::optional<Family> Parser::family() {
    if (!next_.is(Kind::name)) return {};
    const std::string_view text = lexer_.text();
    const auto skip = [&](std::size_t from, auto&& accepts) {
        while (from < text.size() && accepts(text[from])) ++from;
        return from;
    };
    const Range word{next_.range.begin,
                     skip(next_.range.begin, [](char c) { return is_name_char(c) || c == '-'; })};
    const std::size_t colon = skip(word.end, is_blank);
    if (text.substr(colon, 1) != ":") return {};

    Range size{skip(colon + 1, is_blank), std::min(text.find(',', colon), text.size())};
    while (size.end > size.begin && is_blank(text[size.end - 1])) --size.end;
    const std::string digits = size.begin < size.end ? lexer_.text(size) : "";
    if (digits.empty())
        fail({colon, colon + 1}, "a number is missing after the colon",
             fmt::format("write `{}:3`", lexer_.text(word)));
    if (!std::all_of(digits.begin(), digits.end(), is_digit))
        fail(size, fmt::format("`{}` is no size of a family", digits),
             fmt::format("a size is a positive whole number, as in `{}:3`", lexer_.text(word)));

    previous_ = {Kind::number, size};
    lexer_.move_to(size.end);
    next_ = lexer_.next();
    const std::size_t first = std::min(digits.find_first_not_of('0'), digits.size() - 1);
    const bool fits = digits.size() - first <= std::numeric_limits<long>::digits10;
    return Family{lexer_.text(word),
                  fits ? std::stol(digits) : std::numeric_limits<long>::max(),
                  {word.begin, size.end}};
}

Expression Parser::sum() {
    const std::size_t begin = next_.range.begin;
    std::vector<Expression> terms;
    terms.push_back(product());
    while (next_.is(Kind::plus) || next_.is(Kind::minus)) {
        const Token sign = take();
        Expression term = product();
        if (sign.is(Kind::minus))
            term = located(Expression::negation(std::move(term)), sign.range.begin);
        terms.push_back(std::move(term));
    }
    return located(Expression::sum(std::move(terms)), begin);
}

Expression Parser::product() {
    const std::size_t begin = next_.range.begin;
    std::vector<Expression> factors;
    factors.push_back(signed_operand());
    while (next_.is(Kind::times) || next_.is(Kind::over)) {
        const Token sign = take();
        Expression factor = signed_operand();
        if (sign.is(Kind::over))
            factor = located(Expression::reciprocal(std::move(factor)), sign.range.begin);
        factors.push_back(std::move(factor));
    }
    if (next_.starts_operand()) fail_missing_operator();
    return located(Expression::product(std::move(factors)), begin);
}

/// Every way for an expression to stand inside another leads through here, so that the depth of the
/// whole reader is counted in one place.
Expression Parser::signed_operand() {
    if (nesting_ == deepest_nesting)
        fail(next_.range, fmt::format("the text is nested deeper than {}", deepest_nesting));
    ++nesting_;
    const Token sign = next_;
    Expression expression;
    if (sign.is(Kind::plus) || sign.is(Kind::minus)) {
        take();
        expression = signed_operand();
        if (sign.is(Kind::minus))
            expression = located(Expression::negation(std::move(expression)), sign.range.begin);
    } else {
        expression = power();
    }
    --nesting_;
    return expression;
}

Expression Parser::power() {
    Expression base = operand();
    if (!next_.is(Kind::power)) return base;
    take();
    const std::size_t begin = base.range.begin;
    Expression exponent = signed_operand();
    return located(Expression::power(std::move(base), std::move(exponent)), begin);
}

Expression Parser::operand() {
    if (next_.is(Kind::number)) return number();
    if (next_.is(Kind::name)) return name();
    if (next_.is(Kind::open)) return parenthesised();
    fail_missing_operand();
}

Expression Parser::number() {
    const Token token = take();
    return located(read_decimal({lexer_.source(), token.range}), token.range.begin);
}

Expression Parser::name() {
    const Token token = take();
    std::string text = lexer_.text(token.range);
    if (indices_ == Indices::allowed) {
        if (next_.is(Kind::open) && text == "sum") return sum_over_index(token);
        if (next_.is(Kind::open_index)) return indexed_name(token);
        const auto index = indices_of_sums_.find(text);
        if (index != indices_of_sums_.end())
            return located(Expression::integer(index->second), token.range.begin);
    }
    if (next_.is(Kind::open)) return call(token);
    if (find_function(text) != nullptr)
        fail(token.range, fmt::format("`{}` is a function and wants an argument", text),
             fmt::format("write `{}(...)`", text));
    return located(Expression::symbol(std::move(text)), token.range.begin);
}

Expression Parser::call(const Token& name) {
    const std::string text = lexer_.text(name.range);
    const Function* function = find_function(text);
    if (function == nullptr) fail_unknown_function(name);
    const Token open = take();
    if (next_.is(Kind::close))
        fail({name.range.begin, next_.range.end}, fmt::format("`{}` wants an argument", text));
    std::vector<Expression> arguments;
    arguments.push_back(sum());
    while (next_.is(Kind::comma)) {
        take();
        arguments.push_back(sum());
    }
    take_close(open);
    Expression call = located(Expression::call(text, std::move(arguments)), name.range.begin);
    check_argument_count(call, *function);
    return call;
}

Expression Parser::parenthesised() {
    const Token open = take();
    Expression inner = sum();
    if (next_.is(Kind::comma))
        fail(next_.range, "a comma cannot stand within these parentheses",
             "a decimal number has a point: `0.5`");
    take_close(open);
    return located(std::move(inner), open.range.begin);
}

/// The value of what is written at this place.
long Parser::whole_number() {
    const Expression expression = sum();
    const std::optional<long> value = whole_value(expression);
    if (!value)
        fail(expression.range, "a whole number is wanted here",
             "it is made of numbers, +, - and *, and of the index of a sum around it");
    return *value;
}

Expression Parser::indexed_name(const Token& name) {
    take();
    const long index = whole_number();
    take(Kind::close_index, "`]` is wanted here");
    return located(Expression::symbol(fmt::format("{}[{}]", lexer_.text(name.range), index)),
                   name.range.begin);
}

/// The i of `sum(i=`.
std::string Parser::index_of_sum() {
    const Token token = take(Kind::name, "the index of the sum is wanted here");
    std::string name = lexer_.text(token.range);
    const Place place{lexer_.source(), token.range};
    check_parameter_name(name, place);
    if (indices_of_sums_.count(name) != 0)
        throw InputError(fmt::format("`{}` is the index of a sum around this one", name), place,
                         "take another letter");
    take(Kind::equals, "`=` is wanted here");
    return name;
}

/// NOTE: the text of the terms is read once for each value of the index.
Expression Parser::sum_over_index(const Token& name) {
    const Token open = take();
    const std::string index = index_of_sum();
    const long first = whole_number();
    take(Kind::to, "`..` is wanted here, as in `sum(i=1..3, x[i])`");
    const long last = whole_number();
    if (first > last) fail({open.range.end, previous_.range.end}, "this sum has no term");
    if (!next_.is(Kind::comma))
        fail(next_.range, "a comma and the term of the sum are wanted here");
    const std::size_t body = next_.range.end;
    std::vector<Expression> terms;
    for (long value = first; value <= last; ++value) {
        lexer_.move_to(body);
        take();
        indices_of_sums_[index] = value;
        terms.push_back(sum());
    }
    indices_of_sums_.erase(index);
    take_close(open);
    return located(Expression::sum(std::move(terms)), name.range.begin);
}

std::vector<Name> Parser::names() {
    std::vector<Name> names;
    append_names(names);
    while (next_.is(Kind::comma)) {
        take();
        append_names(names);
    }
    if (!next_.is(Kind::end)) fail(next_.range, "names are separated by commas");
    return names;
}

/// `x`, `x[1]`, or `x[1..3]`.
void Parser::append_names(std::vector<Name>& names) {
    const Token token = take(Kind::name, "a name is wanted here");
    const std::string name = lexer_.text(token.range);
    if (!next_.is(Kind::open_index)) {
        names.push_back({name, token.range});
        return;
    }
    take();
    const long first = whole_number();
    long last = first;
    if (!next_.is(Kind::close_index)) {
        take(Kind::to, "`..` is wanted here, as in `x[1..3]`");
        last = whole_number();
    }
    take(Kind::close_index, "`]` is wanted here");
    const Range range{token.range.begin, previous_.range.end};
    if (first > last) fail(range, "there is no such index");
    if (static_cast<std::size_t>(last - first) >= most_names - names.size())
        fail(range, fmt::format("there are more than {} names", most_names));
    for (long index = first; index <= last; ++index)
        names.push_back({fmt::format("{}[{}]", name, index), range});
}

Token Parser::take(Kind kind, const char* what) {
    if (!next_.is(kind)) fail(next_.range, what);
    return take();
}

Token Parser::take() {
    if (++words_ > most_words)
        fail(next_.range, fmt::format("the sums expand to more than {} words", most_words));
    previous_ = next_;
    next_ = lexer_.next();
    return previous_;
}

/// Precondition: what stands inside is read, so that only `)` or the end can follow.
void Parser::take_close(const Token& open) {
    if (!next_.is(Kind::close)) fail(open.range, "this `(` is never closed");
    take();
}

/// The expression with the range from `begin` to the end of the token taken last.
Expression Parser::located(Expression expression, std::size_t begin) const {
    expression.range = {begin, previous_.range.end};
    return expression;
}

void Parser::fail(Range range, std::string what, std::string help) const {
    throw InputError(std::move(what), Place{lexer_.source(), range}, std::move(help));
}

void Parser::fail_missing_operand() const {
    if (next_.is(Kind::end))
        fail({previous_.range.end, previous_.range.end},
             "the text ends where a number, a name or `(` is wanted");
    fail(next_.range,
         fmt::format("a number, a name or `(` is wanted before `{}`", lexer_.text(next_.range)));
}

void Parser::fail_missing_operator() const {
    const auto shown = [&](const Token& token) {
        const bool word = token.is(Kind::number) || token.is(Kind::name);
        return word ? lexer_.text(token.range) : std::string("(...)");
    };
    if (previous_.is(Kind::number) && next_.is(Kind::number))
        fail(next_.range, "a number follows a number", "items of a list are separated by commas");
    fail(next_.range, "an operator is missing before this",
         fmt::format("write `{}*{}` for a product", shown(previous_), shown(next_)));
}

void Parser::fail_unknown_function(const Token& name) const {
    const std::string text = lexer_.text(name.range);
    const std::string product = fmt::format("a product is written `{}*(...)`", text);
    std::vector<std::string_view> names;
    for (const Function& function : functions()) names.push_back(function.name);
    fail(name.range, fmt::format("there is no function `{}`", text),
         is_reserved(text) ? product
                           : did_you_mean(text, names,
                                          fmt::format("the functions are {}; {}",
                                                      fmt::join(names, ", "), product)));
}

void Parser::check_argument_count(const Expression& call, const Function& function) const {
    if (call.arguments.size() == function.arguments) return;
    fail(call.range,
         fmt::format("`{}` takes {} argument{}, not {}", function.name, function.arguments,
                     function.arguments == 1 ? "" : "s", call.arguments.size()));
}

}  // namespace

Expression parse_expression(std::shared_ptr<const Source> source) {
    const Range part = whole(*source);
    return parse_expression(std::move(source), part);
}

Expression parse_expression(std::shared_ptr<const Source> source, Range part) {
    return Parser(std::move(source), part).lone_expression();
}

Expression parse_indexed_expression(std::shared_ptr<const Source> source) {
    const Range part = whole(*source);
    return Parser(std::move(source), part, Indices::allowed).lone_expression();
}

std::vector<Name> parse_names(std::shared_ptr<const Source> source) {
    const Range part = whole(*source);
    return Parser(std::move(source), part, Indices::allowed).names();
}

List parse_list(std::shared_ptr<const Source> source) {
    std::vector<Item> items = Parser(source, whole(*source)).items();
    return {std::move(source), std::move(items)};
}

Family parse_family(std::shared_ptr<const Source> source) {
    const List list = parse_list(source);
    const auto* family = std::get_if<Family>(&list.items.front().what);
    if (family == nullptr || list.items.size() > 1)
        throw InputError("one family with its size is wanted here", Place{source, whole(*source)},
                         "write for example `gauss:3`");
    return *family;
}

}  // namespace hvi::gen
