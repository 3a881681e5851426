// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/equations/stage_terms.hpp"

#include <algorithm>
#include <utility>

#include "generator/exact/numbers/rational.hpp"
#include "generator/expr/fraction.hpp"
#include "generator/read/names.hpp"

namespace hvi::gen {

namespace {

constexpr int digits_of_decimals = 20;  ///< for a coefficient without a closed form

/// Returns a name without an index for a variable's stage values; lower attempts are better names.
std::string stem(const std::string& variable, std::size_t attempt) {
    if (attempt > 0) {
        std::string result = variable;
        while (--attempt > 0) result += "_stage";
        return result;
    }
    std::string capital = variable;
    if ('a' <= capital[0] && capital[0] <= 'z') capital[0] = static_cast<char>(capital[0] - 32);
    return capital;
}

/// Returns the name of a variable's value in a stage: Q_1, and X_1[3] for x[3].
std::string name_in_stage(const std::string& variable, std::size_t stage, std::size_t attempt) {
    const std::string name(without_index(variable));
    return stem(name, attempt) + "_" + std::to_string(stage + 1) + variable.substr(name.size());
}

bool is_zero(const Number& number) { return number.known_zero().value_or(false); }

bool is_negative(const Expression& term) { return as_fraction(term).negative; }

/// An expression as (+-1) * number * rest.
struct Split {
    bool negative = false;
    Expression number = Expression::integer(1);
    Expression rest = Expression::integer(1);
};

Split split(const Expression& expression) {
    Split result;
    if (expression.kind == Expression::Kind::negation) {
        result = split(expression.arguments[0]);
        result.negative = !result.negative;
    } else if (expression.kind == Expression::Kind::number) {
        result.number = expression;
    } else if (expression.kind == Expression::Kind::product &&
               expression.arguments[0].kind == Expression::Kind::number) {
        result.number = expression.arguments[0];
        result.rest =
            Expression::product({expression.arguments.begin() + 1, expression.arguments.end()});
    } else {
        result.rest = expression;
    }
    return result;
}

/// Returns the product of the factors that are not 1.
Expression product(std::vector<Expression> factors) {
    const auto is_one = [](const Expression& factor) { return factor == Expression::integer(1); };
    factors.erase(std::remove_if(factors.begin(), factors.end(), is_one), factors.end());
    return Expression::product(std::move(factors));
}

Expression with_sign(bool negative, Expression expression) {
    return negative ? Expression::negation(std::move(expression)) : expression;
}

/// Returns the value of an Expression::Kind::number, where it is small.
std::optional<Number> small_number(const Expression& expression) {
    constexpr std::size_t most_digits = 18;
    if (expression.numerator.size() > most_digits || expression.denominator.size() > most_digits)
        return std::nullopt;
    return Number(std::stol(expression.numerator)) / Number(std::stol(expression.denominator));
}

}  // namespace

std::set<std::string> symbols_in(const Expression& expression) {
    std::set<std::string> names;
    walk(expression, [&](const Expression& part) {
        if (part.kind == Expression::Kind::symbol) names.insert(part.name);
        return true;
    });
    return names;
}

bool occurs_in(const std::string& symbol, const std::vector<Expression>& expressions) {
    return std::any_of(expressions.begin(), expressions.end(), [&](const Expression& expression) {
        return symbols_in(expression).count(symbol) != 0;
    });
}

std::vector<StageNames> stage_names(const std::vector<std::string>& varying,
                                    const std::set<std::string>& taken, std::size_t stages) {
    for (std::size_t attempt = 0;; ++attempt) {
        std::vector<StageNames> names(stages);
        std::set<std::string> used = taken;
        bool distinct = true;
        for (std::size_t i = 0; i < stages; ++i) {
            for (const std::string& variable : varying) {
                names[i][variable] = name_in_stage(variable, i, attempt);
                distinct = used.insert(names[i][variable]).second && distinct;
            }
        }
        if (distinct) return names;
    }
}

Expression StageTerms::written(const Number& number) {
    if (auto form = number.closed_form()) return *std::move(form);
    is_exact_ = false;
    return Expression::decimal(number.decimal(digits_of_decimals));
}

Row StageTerms::written(const NumberVector& row) {
    Row result{row, {}};
    for (const Number& number : row)
        result.written.push_back(is_zero(number) ? std::nullopt : std::optional(written(number)));
    return result;
}

/// Returns coefficient * derivative. A number in front of the derivative is multiplied with a
/// rational or a decimal coefficient, and stands before any other coefficient.
Expression StageTerms::term(const Number& coefficient, const Expression& coefficient_form,
                            const Expression& derivative) {
    const auto [negative, number, rest] = split(derivative);
    const auto factor = small_number(number);
    const bool multiplies =
        factor && (rational_text(coefficient) || !hvi::gen::is_exact(coefficient));
    return with_sign(negative, multiplies ? product({written(coefficient * *factor), rest})
                                          : product({number, coefficient_form, rest}));
}

/// Returns the terms of sum_j row_j derivative(Q^j, P^j). A summand that is equal in all stages
/// comes once, with the sum of the coefficients.
std::vector<Expression> StageTerms::terms(const Expression& derivative, const Row& row) {
    if (derivative == Expression::integer(0)) return {};
    const std::set<std::string> symbols = symbols_in(derivative);
    const auto occurs = [&](const auto& name) { return symbols.count(name.first) != 0; };
    const bool varies = std::any_of(names_[0].begin(), names_[0].end(), occurs);
    if (!varies) {
        Number sum;
        for (const Number& number : row.numbers) sum = sum + number;
        if (is_zero(sum)) return {};
        return {term(sum, written(sum), derivative)};
    }
    std::vector<Expression> result;
    for (std::size_t j = 0; j < row.written.size(); ++j)
        if (row.written[j])
            result.push_back(term(row.numbers[j], *row.written[j], renamed(derivative, names_[j])));
    return result;
}

Expression StageTerms::multiple(const Number& factor, const Expression& expression) {
    return is_zero(factor) ? Expression::integer(0) : term(factor, written(factor), expression);
}

Expression StageTerms::moved(const Expression& start, const Expression& derivative, const Row& row,
                             bool falls) {
    std::vector<Expression> slopes = terms(derivative, row);
    if (slopes.empty()) return start;
    const bool negative = std::all_of(slopes.begin(), slopes.end(), is_negative);
    for (Expression& slope : slopes) slope = with_sign(negative, std::move(slope));
    const auto [inner, number, rest] = split(Expression::sum(std::move(slopes)));
    const Expression change = product({number, Expression::symbol("h"), rest});
    const Expression moved = with_sign((falls != negative) != inner, change);
    return start == Expression::integer(0) ? moved : Expression::sum({start, moved});
}

Equation StageTerms::time(std::size_t stage, const Number& node) {
    const Expression now = Expression::symbol("t");
    return {name("t", stage),
            is_zero(node)
                ? now
                : Expression::sum({now, product({written(node), Expression::symbol("h")})})};
}

}  // namespace hvi::gen
