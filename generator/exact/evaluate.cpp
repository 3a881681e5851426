// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/evaluate.hpp"

#include <cmath>

#include "generator/exact/integers.hpp"
#include "generator/exact/number_value.hpp"
#include "generator/exact/zero.hpp"

namespace hvi::gen {

namespace {

using Kind = Expression::Kind;

/// Limits on what is worth computing: beyond them a slip is likelier than a method.
constexpr long most_exponent = 1000;
constexpr double most_digits = 10000;
constexpr double most_terms = 10000;

/// How many terms it takes to write a number; one that is known by its enclosures counts as one.
double written_terms(const Number& number) {
    const Element* const element = number.value().element();
    if (element == nullptr) return 1;
    double sum = 0;
    for (const auto& [monomial, coefficient] : element->terms()) {
        sum += static_cast<double>(coefficient.term_count());
    }
    return sum;
}

double written_terms(const ExactFunction& function) {
    double sum = 0;
    for (const ExactTerm& term : function.terms()) sum += written_terms(term.coefficient);
    return sum;
}

/// Digits of the largest rational in a constant, roughly.
double digits_in(const Number& number) {
    const Element* const element = number.value().element();
    if (element == nullptr || !element->is_rational()) return 1;
    const GiNaC::numeric value = element->rational();
    return 0.30103 * (value.numer().int_length() + value.denom().int_length());
}

class Evaluator {
public:
    Evaluator(const std::shared_ptr<const Source>& source, const Ground& ground)
        : source_(source), ground_(ground) {}

    ExactFunction evaluate(const Expression& expression) const {
        try {
            return value(expression);
        } catch (const MathError& error) {
            if (error.place()) throw;
            throw MathError(error.what(), place(expression), error.help());
        } catch (const InputError& error) {
            if (error.place()) throw;
            throw InputError(error.what(), place(expression), error.help());
        }
    }

private:
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
        ExactFunction result;
        for (const Expression& term : expression.arguments) result = result + evaluate(term);
        return result;
    }

    ExactFunction product(const Expression& expression) const {
        ExactFunction result{Number(1)};
        for (const Expression& factor : expression.arguments) {
            const ExactFunction next = evaluate(factor);
            if (written_terms(result) * written_terms(next) > most_terms) refuse_size(expression);
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

    [[noreturn]] void refuse_class(const Expression& expression) const {
        throw InputError("functions of this kind are not built yet", place(expression),
                         "sums and products of powers of tau, and of exp, sin, cos of a*tau + b, "
                         "are integrated exactly");
    }

    /// A function with a zero in [0, 1] is no divisor.
    void refuse_zero(const ExactFunction& divisor, const Expression& expression) const {
        for (const ExactTerm& term : divisor.terms()) {
            if (term.coefficient.has_parameters() || term.rate.has_parameters() ||
                term.frequency.has_parameters()) {
                return;
            }
        }
        const auto zero = zero_in_unit_interval(divisor, ground_);
        if (!zero) { return; }
        throw MathError(
            "the function is not defined on all of [0, 1]: this divisor is 0 at tau = " + *zero,
            place(expression), "a basis function must be integrable on [0, 1]");
    }

    ExactFunction reciprocal(const Expression& argument) const {
        const ExactFunction divisor = evaluate(argument);
        if (const auto number = divisor.constant()) {
            if (number->is_zero()) throw InputError("division by zero", place(argument));
            return ExactFunction(Number(1) / *number);
        }
        const auto& terms = divisor.terms();
        const bool is_exponential = terms.size() == 1 && terms.front().power == 0 &&
                                    terms.front().wave == ExactTerm::Wave::none;
        if (!is_exponential) {
            refuse_zero(divisor, argument);
            refuse_class(argument);
        }
        return ExactFunction(Number(1) / terms.front().coefficient) *
               ExactFunction::exponential(-terms.front().rate);
    }

    ExactFunction raised(const Expression& expression) const {
        const Expression& base = expression.arguments[0];
        const auto exponent = evaluate(expression.arguments[1]);
        if (base.kind == Kind::symbol && base.name == "e") return exponential(exponent, expression);
        const auto number = exponent.constant();
        const Element* const element = number ? number->value().element() : nullptr;
        if (element == nullptr || !element->is_rational()) {
            throw InputError("this exponent is no rational number", place(expression.arguments[1]),
                             "write exp(x*log(a)) for a^x");
        }
        const GiNaC::numeric rational = element->rational();
        if (GiNaC::abs(rational) > most_exponent) refuse_size(expression);
        if (rational.denom().is_equal(2)) {
            return ExactFunction(ground_.sqrt(constant(base))) *
                   integer_power(base, ((rational.numer() - 1) / 2).to_long(), expression);
        }
        if (!rational.is_integer()) {
            throw InputError("roots other than square roots are not built yet",
                             place(expression.arguments[1]));
        }
        return integer_power(base, rational.to_long(), expression);
    }

    ExactFunction integer_power(const Expression& base, long exponent,
                                const Expression& whole) const {
        const ExactFunction factor = exponent < 0 ? reciprocal(base) : evaluate(base);
        const auto count = static_cast<unsigned>(std::abs(exponent));
        // Binomial bound on the terms of the power of a sum.
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

    /// The value of an argument that must not depend on tau.
    Number constant(const Expression& expression) const {
        const auto number = evaluate(expression).constant();
        if (!number) refuse_class(expression);
        return *number;
    }

    /// slope*tau + offset.
    struct Affine {
        Number slope, offset;
    };
    Affine affine(const ExactFunction& function, const Expression& expression) const {
        Affine result;
        for (const ExactTerm& term : function.terms()) {
            const bool fits =
                term.power <= 1 && term.rate.is_zero() && term.wave == ExactTerm::Wave::none;
            if (!fits) refuse_class(expression);
            (term.power == 1 ? result.slope : result.offset) = term.coefficient;
        }
        return result;
    }

    ExactFunction exponential(const ExactFunction& argument, const Expression& expression) const {
        const Affine line = affine(argument, expression);
        return ExactFunction(ground_.exp(line.offset)) * ExactFunction::exponential(line.slope);
    }

    ExactFunction cosine(const Affine& line) const {
        return ExactFunction(ground_.cos(line.offset)) * ExactFunction::cosine(line.slope) +
               ExactFunction(-ground_.sin(line.offset)) * ExactFunction::sine(line.slope);
    }

    ExactFunction sine(const Affine& line) const {
        return ExactFunction(ground_.sin(line.offset)) * ExactFunction::cosine(line.slope) +
               ExactFunction(ground_.cos(line.offset)) * ExactFunction::sine(line.slope);
    }

    ExactFunction call(const Expression& expression) const {
        const std::string& name = expression.name;
        const Expression& argument = expression.arguments.front();
        if (expression.arguments.size() == 1) {
            if (name == "exp") return exponential(evaluate(argument), argument);
            if (name == "cos") return cosine(affine(evaluate(argument), argument));
            if (name == "sin") return sine(affine(evaluate(argument), argument));
            if (name == "cosh" || name == "sinh") return hyperbolic(name == "cosh", argument);
            if (name == "sqrt") return ExactFunction(ground_.sqrt(constant(argument)));
            if (name == "log") return ExactFunction(ground_.log(constant(argument)));
            if (name == "tan" || name == "tanh")
                return ExactFunction(tangent(name == "tan", argument));
        }
        throw InputError("`" + name + "` is not built yet here", place(expression));
    }

    ExactFunction hyperbolic(bool even, const Expression& argument) const {
        const ExactFunction exponent = evaluate(argument);
        const ExactFunction grows = exponential(exponent, argument);
        const ExactFunction decays = exponential(ExactFunction(Number(-1)) * exponent, argument);
        const Number half = Number(1) / Number(2);
        return ExactFunction(half) * grows + ExactFunction(even ? half : -half) * decays;
    }

    Number tangent(bool circular, const Expression& argument) const {
        const Number x = constant(argument);
        const Number grows = circular ? Number(0) : ground_.exp(Number(2) * x);
        const Number above = circular ? ground_.sin(x) : grows - Number(1);
        const Number below = circular ? ground_.cos(x) : grows + Number(1);
        if (below.is_zero()) throw InputError("division by zero", place(argument));
        return above / below;
    }

    const std::shared_ptr<const Source>& source_;
    const Ground& ground_;
};

}  // namespace

ExactFunction evaluate_function(const Expression& expression,
                                const std::shared_ptr<const Source>& source, const Ground& ground) {
    return Evaluator(source, ground).evaluate(expression);
}

Number evaluate_number(const Expression& expression, const std::shared_ptr<const Source>& source,
                       const Ground& ground) {
    const auto number = evaluate_function(expression, source, ground).constant();
    if (!number) throw InputError("this depends on tau", Place{source, expression.range});
    return *number;
}

}  // namespace hvi::gen
