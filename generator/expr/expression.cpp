// Making and comparing expressions.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/expr/expression.hpp"

#include <algorithm>
#include <string_view>
#include <tuple>
#include <utility>

namespace hvi::gen {

namespace {

using Kind = Expression::Kind;

Expression make(Kind kind, std::vector<Expression> arguments) {
    Expression result;
    result.kind = kind;
    result.arguments = std::move(arguments);
    return result;
}

/// Makes a sum without sums in it, or a product without products in it.
Expression make_flat(Kind kind, std::vector<Expression> parts, long neutral) {
    if (parts.empty()) return Expression::integer(neutral);
    if (parts.size() == 1) return std::move(parts.front());
    std::vector<Expression> flat;
    flat.reserve(parts.size());
    for (Expression& part : parts) {
        if (part.kind == kind)
            std::move(part.arguments.begin(), part.arguments.end(), std::back_inserter(flat));
        else
            flat.push_back(std::move(part));
    }
    return make(kind, std::move(flat));
}

bool only_digits(std::string_view text) {
    return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

}  // namespace

Expression Expression::integer(long value) {
    std::string digits = std::to_string(value);
    if (value >= 0) return rational(std::move(digits), "1");
    return negation(rational(digits.substr(1), "1"));
}

Expression Expression::rational(std::string numerator, std::string denominator) {
    HVI_CHECK(only_digits(numerator) && only_digits(denominator));
    HVI_CHECK(denominator.find_first_not_of('0') != std::string::npos);
    Expression result;
    result.numerator = std::move(numerator);
    result.denominator = std::move(denominator);
    return result;
}

Expression Expression::decimal(std::string_view text) {
    if (text.front() == '-') return negation(decimal(text.substr(1)));
    const std::size_t e = text.find('e');
    if (e != std::string_view::npos)
        return product({decimal(text.substr(0, e)),
                        power(integer(10), integer(std::stol(std::string(text.substr(e + 1)))))});
    const std::size_t point = text.find('.');
    if (point == std::string_view::npos) return rational(std::string(text), "1");
    const std::string_view places = text.substr(point + 1);
    Expression result = rational(std::string(text.substr(0, point)) + std::string(places),
                                 "1" + std::string(places.size(), '0'));
    result.name = text;
    return result;
}

Expression Expression::symbol(std::string name) {
    Expression result = make(Kind::symbol, {});
    result.name = std::move(name);
    return result;
}

Expression Expression::sum(std::vector<Expression> terms) {
    return make_flat(Kind::sum, std::move(terms), 0);
}

Expression Expression::product(std::vector<Expression> factors) {
    return make_flat(Kind::product, std::move(factors), 1);
}

Expression Expression::negation(Expression argument) {
    std::vector<Expression> arguments;
    arguments.push_back(std::move(argument));
    return make(Kind::negation, std::move(arguments));
}

Expression Expression::reciprocal(Expression argument) {
    std::vector<Expression> arguments;
    arguments.push_back(std::move(argument));
    return make(Kind::reciprocal, std::move(arguments));
}

Expression Expression::power(Expression base, Expression exponent) {
    std::vector<Expression> arguments;
    arguments.push_back(std::move(base));
    arguments.push_back(std::move(exponent));
    return make(Kind::power, std::move(arguments));
}

Expression Expression::call(std::string function, std::vector<Expression> arguments) {
    HVI_CHECK(!arguments.empty());
    Expression result = make(Kind::call, std::move(arguments));
    result.name = std::move(function);
    return result;
}

Expression Expression::element(std::string name, std::vector<Expression> indices) {
    HVI_CHECK(!indices.empty());
    Expression result = make(Kind::element, std::move(indices));
    result.name = std::move(name);
    return result;
}

Expression Expression::sum_over(std::string index, Expression first, Expression last,
                                Expression term) {
    std::vector<Expression> arguments;
    arguments.push_back(std::move(first));
    arguments.push_back(std::move(last));
    arguments.push_back(std::move(term));
    Expression result = make(Kind::sum_over, std::move(arguments));
    result.name = std::move(index);
    return result;
}

bool operator==(const Expression& left, const Expression& right) {
    return left.kind == right.kind && left.name == right.name &&
           left.numerator == right.numerator && left.denominator == right.denominator &&
           left.arguments == right.arguments;
}

namespace {

/// Adds the expression and all of its parts, each before its own parts.
void collect(const Expression& expression, std::vector<const Expression*>& parts) {
    parts.push_back(&expression);
    for (const Expression& argument : expression.arguments) collect(argument, parts);
}

std::vector<const Expression*> leaves(std::vector<const Expression*> parts) {
    std::erase_if(parts, [](const Expression* part) { return !part->arguments.empty(); });
    return parts;
}

bool leaf_precedes(const Expression* left, const Expression* right) {
    const auto key = [](const Expression& leaf) {
        return std::tuple(leaf.kind, leaf.numerator.size(), std::string_view(leaf.numerator),
                          leaf.denominator.size(), std::string_view(leaf.denominator),
                          std::string_view(leaf.name));
    };
    return key(*left) < key(*right);
}

bool operation_precedes(const Expression* left, const Expression* right) {
    const auto key = [](const Expression& part) {
        return std::tuple(part.kind, part.arguments.size(), std::string_view(part.name));
    };
    return key(*left) < key(*right);
}

}  // namespace

bool precedes(const Expression& left, const Expression& right) {
    std::vector<const Expression*> all_left, all_right;
    collect(left, all_left);
    collect(right, all_right);
    const auto is_less = [](const auto& a, const auto& b, auto less) {
        return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), less);
    };
    const auto left_leaves = leaves(all_left), right_leaves = leaves(all_right);
    if (is_less(left_leaves, right_leaves, leaf_precedes)) return true;
    if (is_less(right_leaves, left_leaves, leaf_precedes)) return false;
    return is_less(all_left, all_right, operation_precedes);
}

std::size_t word_count(const Expression& expression) {
    std::size_t count = 1;
    for (const Expression& argument : expression.arguments) count += word_count(argument);
    return count;
}

Expression with_arguments(Expression expression, std::vector<Expression> arguments) {
    const Range range = expression.range;
    switch (expression.kind) {
    case Kind::sum: expression = Expression::sum(std::move(arguments)); break;
    case Kind::product: expression = Expression::product(std::move(arguments)); break;
    default: expression.arguments = std::move(arguments);
    }
    expression.range = range;
    return expression;
}

Expression renamed(const Expression& expression, const std::map<std::string, std::string>& names) {
    Expression result = expression;
    if (result.kind == Kind::symbol) {
        const auto found = names.find(result.name);
        if (found != names.end()) result.name = found->second;
    }
    for (Expression& argument : result.arguments) argument = renamed(argument, names);
    return result;
}

bool has_sum(const Expression& expression) {
    return expression.kind == Kind::sum_over ||
           std::any_of(expression.arguments.begin(), expression.arguments.end(), has_sum);
}

Expression replaced(const Expression& expression, const std::map<std::string, Expression>& by) {
    if (expression.kind == Kind::symbol) {
        const auto found = by.find(expression.name);
        if (found == by.end()) return expression;
        Expression result = found->second;
        result.range = expression.range;
        return result;
    }
    std::vector<Expression> arguments;
    for (const Expression& argument : expression.arguments)
        arguments.push_back(replaced(argument, by));
    if (expression.kind == Kind::sum_over && by.count(expression.name) != 0) {
        std::map<std::string, Expression> others = by;
        others.erase(expression.name);
        arguments[2] = replaced(expression.arguments[2], others);
    }
    return with_arguments(expression, std::move(arguments));
}

}  // namespace hvi::gen
