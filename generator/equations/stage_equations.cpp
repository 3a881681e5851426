// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/equations/stage_equations.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "generator/exact/numbers/rational.hpp"
#include "generator/expr/fraction.hpp"
#include "generator/read/names.hpp"
#include "generator/stages/stage_graph.hpp"

namespace hvi::gen {

namespace {

constexpr int digits = 20;  ///< of a coefficient without a closed form

using Names = std::map<std::string, std::string>;

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

/// The ways to call the values of a variable in the stages, the best first, without an index.
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

/// The name of a variable's value in a stage: Q_1, and X_1[3] of x[3].
std::string name_in_stage(const std::string& variable, std::size_t stage, std::size_t attempt) {
    const std::string name(without_index(variable));
    return stem(name, attempt) + "_" + std::to_string(stage + 1) + variable.substr(name.size());
}

/// Coordinates, momenta, and the time where it occurs.
std::vector<std::string> names_that_vary(const Hamiltonian& H) {
    std::vector<std::string> names = variables(H);
    if (depends_on_time(H)) names.push_back("t");
    return names;
}

/// For each stage, the names of the values there of all that varies: Q_1 for q, but q_1 where H has
/// Q or Q_1 already, and q_stage_1 where that is taken too.
std::vector<Names> stage_names(const Hamiltonian& H, std::size_t stages) {
    std::set<std::string> taken = symbols_in(H.expression);
    const std::vector<std::string> all = names_that_vary(H);
    taken.insert(all.begin(), all.end());
    for (std::size_t attempt = 0;; ++attempt) {
        std::vector<Names> names(stages);
        std::set<std::string> used = taken;
        bool distinct = true;
        for (std::size_t i = 0; i < stages; ++i) {
            for (const std::string& variable : all) {
                names[i][variable] = name_in_stage(variable, i, attempt);
                distinct = used.insert(names[i][variable]).second && distinct;
            }
        }
        if (distinct) return names;
    }
}

/// A row of coefficients: the numbers and what is written for them, nothing for zero.
struct Row {
    NumberVector numbers;
    std::vector<std::optional<Expression>> written;
};

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

/// The product of what is not 1.
Expression product(std::vector<Expression> factors) {
    const auto is_one = [](const Expression& factor) { return factor == Expression::integer(1); };
    factors.erase(std::remove_if(factors.begin(), factors.end(), is_one), factors.end());
    return Expression::product(std::move(factors));
}

Expression with_sign(bool negative, Expression expression) {
    return negative ? Expression::negation(std::move(expression)) : expression;
}

/// The value of an Expression::Kind::number, where it is small.
std::optional<Number> small_number(const Expression& expression) {
    constexpr std::size_t most_digits = 18;
    if (expression.numerator.size() > most_digits || expression.denominator.size() > most_digits)
        return std::nullopt;
    return Number(std::stol(expression.numerator)) / Number(std::stol(expression.denominator));
}

class Writer {
public:
    Writer(const ButcherPair& pair, const Hamiltonian& H, const Gradient& gradient)
        : H_(H),
          gradient_(gradient),
          names_(stage_names(H, pair.stages())),
          method_(partitioned_method(pair)),
          nodes_(pair.c) {
        for (const NumberVector& row : pair.A) A_.push_back(written(row));
        for (const NumberVector& row : pair.A_tilde) A_tilde_.push_back(written(row));
        b_ = written(pair.b);
    }

    [[nodiscard]] StageEquations equations();

private:
    [[nodiscard]] Equation time(std::size_t stage);
    [[nodiscard]] Expression written(const Number& number);
    [[nodiscard]] Row written(const NumberVector& row);
    [[nodiscard]] Expression term(const Number& coefficient, const Expression& coefficient_form,
                                  const Expression& derivative);
    [[nodiscard]] std::vector<Expression> terms(const Expression& derivative, const Row& row);
    [[nodiscard]] Expression value(std::size_t variable, const Row& for_q, const Row& for_p);
    [[nodiscard]] bool is_needed(const std::string& variable) const;
    [[nodiscard]] SlopePattern slopes() const;
    void set_stages(StageEquations& result);

    const Hamiltonian& H_;
    const Gradient& gradient_;
    std::vector<Names> names_;
    PartitionedMethod method_;
    NumberVector nodes_;
    std::vector<Row> A_, A_tilde_;
    Row b_;
    bool is_exact_ = true;
};

Expression Writer::written(const Number& number) {
    if (auto form = number.closed_form()) return *std::move(form);
    is_exact_ = false;
    return Expression::decimal(number.decimal(digits));
}

Row Writer::written(const NumberVector& row) {
    Row result{row, {}};
    for (const Number& number : row)
        result.written.push_back(is_zero(number) ? std::nullopt : std::optional(written(number)));
    return result;
}

/// coefficient * derivative. A number in front of the derivative is multiplied with a rational or
/// a decimal, and stands before any other coefficient.
Expression Writer::term(const Number& coefficient, const Expression& coefficient_form,
                        const Expression& derivative) {
    const auto [negative, number, rest] = split(derivative);
    const auto factor = small_number(number);
    const bool multiplies = factor && (rational_text(coefficient) || !is_exact(coefficient));
    return with_sign(negative, multiplies ? product({written(coefficient * *factor), rest})
                                          : product({number, coefficient_form, rest}));
}

/// The terms of sum_j row_j derivative(Q^j, P^j). What is the same in all stages comes once, with
/// the sum of the coefficients.
std::vector<Expression> Writer::terms(const Expression& derivative, const Row& row) {
    if (derivative == Expression::integer(0)) return {};
    const std::set<std::string> symbols = symbols_in(derivative);
    const std::vector<std::string> all = names_that_vary(H_);
    const bool varies = std::any_of(all.begin(), all.end(), [&](const std::string& variable) {
        return symbols.count(variable) != 0;
    });
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

/// q + h sum_j a_j dH/dp(Q^j, P^j), or p - h sum_j a~_j dH/dq(Q^j, P^j).
Expression Writer::value(std::size_t variable, const Row& for_q, const Row& for_p) {
    const std::size_t n = H_.degrees_of_freedom();
    const bool is_q = variable < n;
    const Expression start =
        Expression::symbol(is_q ? H_.coordinates[variable] : H_.momenta[variable - n]);
    std::vector<Expression> slopes = is_q ? terms(gradient_.by_momenta[variable], for_q)
                                          : terms(gradient_.by_coordinates[variable - n], for_p);
    if (slopes.empty()) return start;
    const bool negative = std::all_of(slopes.begin(), slopes.end(), is_negative);
    for (Expression& slope : slopes) slope = with_sign(negative, std::move(slope));
    const auto [inner, number, rest] = split(Expression::sum(std::move(slopes)));
    const Expression change = product({number, Expression::symbol("h"), rest});
    return Expression::sum({start, with_sign((is_q == negative) != inner, change)});
}

bool Writer::is_needed(const std::string& variable) const {
    return occurs_in(variable, gradient_.by_coordinates) ||
           occurs_in(variable, gradient_.by_momenta);
}

/// Which derivatives have which variables.
SlopePattern Writer::slopes() const {
    const auto pattern = [](const std::vector<Expression>& derivatives,
                            const std::vector<std::string>& names) {
        Pattern result;
        for (const Expression& derivative : derivatives) {
            const std::set<std::string> symbols = symbols_in(derivative);
            std::vector<bool>& row = result.emplace_back();
            for (const std::string& name : names) row.push_back(symbols.count(name) != 0);
        }
        return result;
    };
    return {pattern(gradient_.by_momenta, H_.coordinates),
            pattern(gradient_.by_momenta, H_.momenta),
            pattern(gradient_.by_coordinates, H_.coordinates),
            pattern(gradient_.by_coordinates, H_.momenta)};
}

/// Adds those of the stage values that a derivative depends on.
void Writer::set_stages(StageEquations& result) {
    std::vector<StageNode> values;
    result.is_explicit = true;
    for (const std::vector<StageNode>& group : groups_in_order(stage_pattern(method_, slopes()))) {
        result.is_explicit = result.is_explicit && group.size() == 1;
        values.insert(values.end(), group.begin(), group.end());
    }
    if (!result.is_explicit)
        std::sort(values.begin(), values.end(), [](const StageNode& a, const StageNode& b) {
            return std::tie(a.kind, a.variable, a.index) < std::tie(b.kind, b.variable, b.index);
        });
    const std::vector<std::string> all = variables(H_);
    for (const StageNode& node : values) {
        const bool is_q = node.kind == StageNode::Kind::Q;
        if (!is_q && node.kind != StageNode::Kind::P) continue;
        const std::size_t k = is_q ? node.variable : H_.degrees_of_freedom() + node.variable;
        const std::size_t i = node.index;
        if (is_needed(all[k]))
            result.stages.push_back({names_[i].at(all[k]), value(k, A_[i], A_tilde_[i])});
    }
}

/// T_i = t + c_i h. An H that depends on time is one without, H(q, p, t) + e, with t as one more
/// coordinate and e for its momentum. Then t' = 1, of which (4.18) makes t + h sum_j a_ij = t + c_i
/// h in the stages, since constants are in the span of the basis; and nothing else depends on e.
Equation Writer::time(std::size_t stage) {
    const Expression now = Expression::symbol("t");
    const Number& node = nodes_[stage];
    return {names_[stage].at("t"),
            is_zero(node)
                ? now
                : Expression::sum({now, product({written(node), Expression::symbol("h")})})};
}

StageEquations Writer::equations() {
    StageEquations result;
    if (is_needed("t"))
        for (std::size_t i = 0; i < names_.size(); ++i) result.stages.push_back(time(i));
    set_stages(result);
    const std::vector<std::string> all = variables(H_);
    for (std::size_t k = 0; k < all.size(); ++k)
        result.update.push_back({all[k], value(k, b_, b_)});
    result.is_exact = is_exact_;
    return result;
}

}  // namespace

StageEquations stage_equations(const ButcherPair& pair, const Hamiltonian& hamiltonian,
                               const Gradient& gradient) {
    return Writer(pair, hamiltonian, gradient).equations();
}

}  // namespace hvi::gen
