// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/read/expression_parser.hpp"

#include <fmt/format.h>

#include <utility>

#include "generator/read/decimal.hpp"
#include "generator/read/names.hpp"
#include "generator/read/nearest.hpp"

namespace hvi::gen {

namespace {

constexpr int deepest_nesting = 200;

}  // namespace

Expression ExpressionParser::lone_expression() {
    Expression expression = sum();
    if (next_is(Kind::comma))
        fail(next().range, "one expression is wanted here, not a list",
             "a decimal number has a point: `0.5`");
    if (next_is(Kind::close)) fail(next().range, "there is no `(` for this `)`");
    if (!next_is(Kind::end))
        fail(next().range, fmt::format("`{}` cannot stand here", text(next().range)));
    return expression;
}

Expression ExpressionParser::sum() {
    Expression result = side();
    if (next().compares())
        fail(next().range, fmt::format("`{}` cannot stand here", text(next().range)),
             "a comparison stands in a choice: `if(a < b, x, y)`");
    return result;
}

Expression ExpressionParser::side() {
    const std::size_t begin = next().range.begin;
    std::vector<Expression> terms;
    terms.push_back(product());
    while (next_is(Kind::plus) || next_is(Kind::minus)) {
        const Token sign = take();
        Expression term = product();
        if (sign.is(Kind::minus))
            term = located(Expression::negation(std::move(term)), sign.range.begin);
        terms.push_back(std::move(term));
    }
    return located(Expression::sum(std::move(terms)), begin);
}

Expression ExpressionParser::product() {
    const std::size_t begin = next().range.begin;
    std::vector<Expression> factors;
    factors.push_back(signed_operand());
    while (next_is(Kind::times) || next_is(Kind::over)) {
        const Token sign = take();
        Expression factor = signed_operand();
        if (sign.is(Kind::over))
            factor = located(Expression::reciprocal(std::move(factor)), sign.range.begin);
        factors.push_back(std::move(factor));
    }
    if (next().starts_operand()) fail_missing_operator();
    return located(Expression::product(std::move(factors)), begin);
}

/// Reads an operand with its signs. Every nested expression passes through here, so that the depth
/// of the whole reader is counted in one place.
Expression ExpressionParser::signed_operand() {
    if (nesting_ == deepest_nesting)
        fail(next().range, fmt::format("the text is nested deeper than {}", deepest_nesting));
    ++nesting_;
    const Token sign = next();
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

Expression ExpressionParser::power() {
    Expression base = operand();
    if (!next_is(Kind::power)) return base;
    take();
    const std::size_t begin = base.range.begin;
    Expression exponent = signed_operand();
    return located(Expression::power(std::move(base), std::move(exponent)), begin);
}

Expression ExpressionParser::operand() {
    if (next_is(Kind::number)) return number();
    if (next_is(Kind::name)) return name(take());
    if (next_is(Kind::open)) return parenthesised();
    fail_missing_operand();
}

Expression ExpressionParser::number() {
    const Token token = take();
    return located(read_decimal(place(token.range)), token.range.begin);
}

Expression ExpressionParser::name(const Token& name) {
    if (next_is(Kind::open)) return call(name);
    std::string symbol = text(name.range);
    if (is_function(symbol) || is_own(symbol))
        fail(name.range, fmt::format("`{}` is a function and wants an argument", symbol),
             fmt::format("write `{}(...)`", symbol));
    return located(Expression::symbol(std::move(symbol)), name.range.begin);
}

Expression ExpressionParser::call(const Token& name) {
    const std::string called = text(name.range);
    if (called == "if") return choice(name);
    if (find_function(called) == nullptr && !is_own(called)) fail_unknown_function(name);
    const Token open = take();
    if (next_is(Kind::close))
        fail({name.range.begin, next().range.end}, fmt::format("`{}` wants an argument", called));
    std::vector<Expression> arguments;
    arguments.push_back(sum());
    while (next_is(Kind::comma)) {
        take();
        arguments.push_back(sum());
    }
    take_close(open);
    Expression call = located(Expression::call(called, std::move(arguments)), name.range.begin);
    check_argument_count(call);
    return call;
}

/// NOTE: a > b is b < a.
Expression ExpressionParser::choice(const Token& name) {
    const Token open = take();
    std::vector<Expression> arguments;
    arguments.push_back(side());
    const Token sign = comparison();
    arguments.push_back(sum());
    const bool is_turned = sign.is(Kind::greater) || sign.is(Kind::greater_or_equal);
    if (is_turned) std::swap(arguments[0], arguments[1]);
    while (next_is(Kind::comma)) {
        take();
        arguments.push_back(sum());
    }
    take_close(open);
    const bool is_strict = sign.is(Kind::less) || sign.is(Kind::greater);
    const std::size_t count = arguments.size() - 1;
    Expression result = located(Expression::call(is_strict ? "if<" : "if<=", std::move(arguments)),
                                name.range.begin);
    if (count != 3)
        fail(result.range, fmt::format("`if` takes a comparison and 2 values, not {}", count - 1),
             "write `if(a < b, x, y)` for x where a < b, and y elsewhere");
    return result;
}

Token ExpressionParser::comparison() {
    if (next().compares()) return take();
    fail(next_is(Kind::end) ? previous().range : next().range, "`if` wants a comparison first",
         "write `if(a < b, x, y)`, with `<`, `<=`, `>` or `>=`");
}

Expression ExpressionParser::parenthesised() {
    const Token open = take();
    Expression inner = sum();
    if (next_is(Kind::comma))
        fail(next().range, "a comma cannot stand within these parentheses",
             "a decimal number has a point: `0.5`");
    take_close(open);
    return located(std::move(inner), open.range.begin);
}

void ExpressionParser::fail_missing_operand() const {
    if (next_is(Kind::end))
        fail({previous().range.end, previous().range.end},
             "the text ends where a number, a name or `(` is wanted");
    fail(next().range,
         fmt::format("a number, a name or `(` is wanted before `{}`", text(next().range)));
}

void ExpressionParser::fail_missing_operator() const {
    const auto shown = [&](const Token& token) {
        const bool word = token.is(Kind::number) || token.is(Kind::name);
        return word ? text(token.range) : std::string("(...)");
    };
    if (previous().is(Kind::number) && next_is(Kind::number))
        fail(next().range, "a number follows a number", "items of a list are separated by commas");
    fail(next().range, "an operator is missing before this",
         fmt::format("write `{}*{}` for a product", shown(previous()), shown(next())));
}

void ExpressionParser::fail_unknown_function(const Token& name) const {
    const std::string called = text(name.range);
    const std::string product = fmt::format("a product is written `{}*(...)`", called);
    const std::string_view others = is_list() ? "" : "; a scene has others in [functions]";
    std::vector<std::string_view> names;
    for (const Function& function : functions())
        if (!is_hidden(function.name) && (is_list() || !is_of_lists(function.name)))
            names.push_back(function.name);
    names.push_back("if");
    for (const auto& [own, count] : own_) names.push_back(own);
    fail(name.range, fmt::format("there is no function `{}`", called),
         is_reserved(called) ? product
                             : did_you_mean(called, names,
                                            fmt::format("the functions are {}{}; {}",
                                                        fmt::join(names, ", "), others, product)));
}

void ExpressionParser::check_argument_count(const Expression& call) const {
    const std::size_t wanted =
        is_own(call.name) ? own_.at(call.name) : find_function(call.name)->arguments;
    if (call.arguments.size() == wanted) return;
    fail(call.range, fmt::format("`{}` takes {} argument{}, not {}", call.name, wanted,
                                 wanted == 1 ? "" : "s", call.arguments.size()));
}

}  // namespace hvi::gen
