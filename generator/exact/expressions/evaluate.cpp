// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/expressions/evaluate.hpp"

#include <cmath>

#include "generator/exact/expressions/compose.hpp"
#include "generator/exact/expressions/spline.hpp"
#include "generator/exact/functions/division_by_zero.hpp"
#include "generator/exact/functions/elementary.hpp"
#include "generator/exact/numbers/number_value.hpp"
#include "generator/exact/numbers/rational.hpp"
#include "generator/expr/functions.hpp"
#include "generator/expr/own_functions.hpp"
#include "generator/read/names.hpp"

namespace hvi::gen {

namespace {

using Kind = Expression::Kind;

/// Limits on what is worth computing: beyond them a slip is likelier than a method.
constexpr long most_exponent = 1000;
constexpr double most_digits = 10000;
constexpr double most_terms = 10000;
constexpr double most_terms_of_number = 1e6;

/// Returns how many terms it takes to write a number. A number that is known by its enclosures
/// counts as one.
double written_terms(const Number& number) {
    const Element* const element = number.value().element();
    if (element == nullptr) return 1;
    std::size_t sum = 0;
    for (const auto& [monomial, coefficient] : element->numerator()) {
        sum += coefficient.term_count() + element->denominator().term_count();
    }
    return static_cast<double>(sum);
}

double written_terms(const ExactFunction& function) {
    double sum = 0;
    for (const ExactTerm& term : function.terms()) sum += written_terms(term.coefficient);
    return sum;
}

/// Returns the digits of the largest rational in a constant, approximately.
double digits_in(const Number& number) {
    const Element* const element = number.value().element();
    if (element == nullptr || !element->is_rational()) return 1;
    const Rational value = element->rational();
    const std::size_t bits = value.numerator().bits() + value.denominator().bits();
    return 0.30103 * static_cast<double>(bits);
}

/// Returns whether an expression has nothing but numbers, pi and e, and functions that have exact
/// values.
bool is_number(const Expression& expression) {
    bool number = own_call_in(expression) == nullptr;
    walk(expression, [&](const Expression& part) {
        const bool is_name = part.kind == Kind::symbol || part.kind == Kind::element;
        number = number && (!is_name || is_constant(part.name));
        return number;
    });
    return number;
}

class Evaluator {
public:
    Evaluator(const std::shared_ptr<const Source>& source, const Ground& ground,
              const Setting& setting)
        : source_(source),
          ground_(ground),
          setting_(setting),
          composition_(setting.domain, ground) {}

    ExactFunction whole(const Expression& expression) const {
        return placed(expression, [&] {
            ExactFunction result = evaluate(expression);
            composition_.check_integrable(result);
            return result;
        });
    }

private:
    ExactFunction evaluate(const Expression& expression) const {
        return placed(expression, [&] { return value(expression); });
    }

    /// Returns the result of `work`; its errors get the place of the expression when they have
    /// none.
    template <class Work>
    ExactFunction placed(const Expression& expression, Work work) const {
        try {
            return work();
        } catch (const MathError& error) {
            if (error.place()) throw;
            throw MathError(error.what(), place(expression), error.help());
        } catch (const DivisionByZero& error) {
            if (error.place()) throw;
            throw DivisionByZero(place(expression));
        } catch (const InputError& error) {
            if (error.place()) throw;
            throw InputError(error.what(), place(expression), error.help());
        }
    }

    [[nodiscard]] Place place(const Expression& expression) const {
        return {source_, expression.range};
    }

    ExactFunction value(const Expression& expression) const {
        switch (expression.kind) {
        case Kind::number:
            return ExactFunction(ground_.rational(expression.numerator, expression.denominator));
        case Kind::symbol: return symbol(expression);
        case Kind::sum: return sum(expression);
        case Kind::product: return product(expression);
        case Kind::negation: return ExactFunction(Number(-1)) * evaluate(expression.arguments[0]);
        case Kind::reciprocal: return reciprocal(expression.arguments[0]);
        case Kind::power: return raised(expression);
        case Kind::call: return call(expression);
        case Kind::element:
        case Kind::sum_over: break;
        }
        HVI_CHECK(false && "every kind of expression has a value");
        return {};
    }

    ExactFunction symbol(const Expression& expression) const {
        if (expression.name == "tau") return ExactFunction::tau();
        if (expression.name == "pi") return ExactFunction(ground_.pi());
        if (expression.name == "e") return ExactFunction(ground_.exp(Number(1)));
        return ExactFunction(ground_.parameter(expression.name));
    }

    ExactFunction sum(const Expression& expression) const {
        // NOTE: in pairs, pairs of pairs and so on: added to one sum, each term would be brought
        // over the common denominator of all that came before.
        std::vector<ExactFunction> parts;
        for (const Expression& term : expression.arguments) parts.push_back(evaluate(term));
        for (; parts.size() > 1; parts.resize((parts.size() + 1) / 2)) {
            for (std::size_t i = 0; 2 * i + 1 < parts.size(); ++i) {
                parts[i] = parts[2 * i] + parts[2 * i + 1];
            }
            if (parts.size() % 2 == 1) parts[parts.size() / 2] = parts.back();
        }
        return parts.front();
    }

    ExactFunction product(const Expression& expression) const {
        ExactFunction result{Number(1)};
        for (const Expression& factor : expression.arguments) {
            const ExactFunction next = evaluate(factor);
            const bool is_number = result.constant() && next.constant();
            const double most = is_number ? most_terms_of_number : most_terms;
            if (written_terms(result) * written_terms(next) > most) refuse_size(expression);
            result = result * next;
            if (const auto number = result.constant()) {
                if (digits_in(*number) > most_digits) refuse_size(expression);
            }
        }
        return result;
    }

    [[noreturn]] void refuse_size(const Expression& expression) const {
        throw InputError("this is larger than any method needs", place(expression));
    }

    ExactFunction reciprocal(const Expression& argument) const {
        const ExactFunction divisor = evaluate(argument);
        if (const auto number = divisor.constant()) {
            if (number->is_zero()) throw DivisionByZero(place(argument));
            return ExactFunction(Number(1) / *number);
        }
        return placed(argument, [&] { return composition_.reciprocal(divisor); });
    }

    ExactFunction raised(const Expression& expression) const {
        const Expression& base = expression.arguments[0];
        const auto exponent = evaluate(expression.arguments[1]);
        if (base.kind == Kind::symbol && base.name == "e")
            return composition_.call("exp", exponent);
        const auto number = exponent.constant();
        if (!number || !rational_text(*number)) {
            throw InputError("this exponent is no rational number", place(expression.arguments[1]),
                             "write exp(x*log(a)) for a^x");
        }
        const auto fraction = small_ratio(*number);
        const bool fits = fraction &&
                          std::abs(fraction->above) <= most_exponent * fraction->below &&
                          fraction->below <= most_exponent;
        if (!fits) refuse_size(expression);
        if (fraction->is_integer()) return integer_power(base, fraction->above, expression);
        // NOTE: the whole part of an exponent is multiplied out, as long as it is not large.
        const long whole = fraction->floor();
        const ExactFunction inner = evaluate(base);
        if (whole > 0 && inner.constant()) {
            return composition_.root(inner,
                                     {fraction->above - whole * fraction->below, fraction->below}) *
                   integer_power(base, whole, expression);
        }
        return composition_.root(inner, *fraction);
    }

    ExactFunction integer_power(const Expression& base, long exponent,
                                const Expression& whole) const {
        const ExactFunction factor = exponent < 0 ? reciprocal(base) : evaluate(base);
        const auto count = static_cast<unsigned>(std::abs(exponent));
        // binomial bound on the terms of the power of a sum
        const double terms = written_terms(factor);
        double bound = 1;
        for (unsigned i = 1; i <= count && bound <= most_terms; ++i) {
            bound *= (terms - 1 + i) / i;
        }
        const auto number = factor.constant();
        if (bound > most_terms || (number && digits_in(*number) * count > most_digits)) {
            refuse_size(whole);
        }
        ExactFunction result{Number(1)};
        ExactFunction square = factor;
        for (unsigned rest = count; rest != 0; rest /= 2) {
            if (rest % 2 == 1) result = result * square;
            if (rest > 1) square = square * square;
        }
        return result;
    }

    ExactFunction call(const Expression& expression) const {
        if (expression.name == "bspline") return spline(expression);
        if (expression.name == "roots") {
            throw InputError("`" + expression.name + "` cannot stand here", place(expression));
        }
        if (is_if(expression.name)) return choice(expression);
        if (is_own_function(expression.name)) {
            throw InputError("`" + expression.name +
                                 "` is a function of your own: it has no exact "
                                 "value",
                             place(expression));
        }
        const Function& function = *find_function(expression.name);
        if (function.arguments == 2 || !function.is_smooth()) return of_numbers(expression);
        const ExactFunction argument = evaluate(expression.arguments.front());
        if (expression.name == "sqrt") return composition_.root(argument, {1, 2});
        return composition_.call(expression.name, argument);
    }

    /// Returns the chosen alternative. NOTE: the others need not have a value.
    ExactFunction choice(const Expression& expression) const {
        const Number a = number(expression.arguments[0], "if");
        const Number b = number(expression.arguments[1], "if");
        const bool holds = compares(expression.name == "if<", a, b);
        return evaluate(expression.arguments[holds ? 2 : 3]);
    }

    ExactFunction of_numbers(const Expression& expression) const {
        NumberVector arguments;
        for (const Expression& argument : expression.arguments) {
            arguments.push_back(number(argument, expression.name));
        }
        return ExactFunction(elementary(expression.name, arguments, ground_));
    }

    [[nodiscard]] Number number(const Expression& argument, const std::string& function) const {
        const auto result = evaluate(argument).constant();
        if (!result) {
            throw InputError("the integrals of `" + function + "` of a function are not built yet",
                             place(argument), "here it can be called of numbers");
        }
        return *result;
    }

    ExactFunction spline(const Expression& expression) const {
        const SplineIndex which = spline_index(expression);
        const auto count = setting_.splines.find(which.degree);
        HVI_CHECK(count != setting_.splines.end() && which.index < count->second);
        if (count->second <= which.degree) {
            throw InputError("B-splines of degree " + std::to_string(which.degree) + " come as " +
                                 std::to_string(which.degree + 1) +
                                 " or more, and the largest index here is " +
                                 std::to_string(count->second - 1),
                             place(expression),
                             "the largest index i of a degree k tells the knots: i+1 functions on "
                             "i+1-k intervals of equal length");
        }
        return b_spline(which, count->second, ground_);
    }

    const std::shared_ptr<const Source>& source_;
    const Ground& ground_;
    const Setting& setting_;
    FunctionComposition composition_;
};

}  // namespace

ExactFunction evaluate_function(const Expression& expression,
                                const std::shared_ptr<const Source>& source, const Ground& ground,
                                const Setting& setting) {
    return Evaluator(source, ground, setting).whole(expression);
}

Number evaluate_number(const Expression& expression, const std::shared_ptr<const Source>& source,
                       const Ground& ground) {
    const auto number = evaluate_function(expression, source, ground).constant();
    if (!number) throw InputError("this depends on tau", Place{source, expression.range});
    return *number;
}

void check_numbers(const Expression& expression, const std::shared_ptr<const Source>& source) {
    walk(expression, [&](const Expression& part) {
        if (part.kind == Kind::number || !is_number(part)) return true;
        on_new_ground([&](const Ground& ground) { return evaluate_number(part, source, ground); });
        return false;
    });
}

bool is_proved_zero(const Expression& expression) {
    try {
        return on_new_ground([&](const Ground& ground) {
            const Number value = evaluate_number(expression, nullptr, ground);
            return is_exact(value) && value.is_zero();
        });
    } catch (const MathError&) { return false; } catch (const InputError&) {
        return false;
    }
}

}  // namespace hvi::gen
