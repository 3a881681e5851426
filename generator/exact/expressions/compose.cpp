// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/expressions/compose.hpp"

#include "generator/exact/functions/elementary.hpp"
#include "generator/expr/functions.hpp"

namespace hvi::gen {

namespace {

const char* const must_be_integrable = "a basis function must be integrable on [0, 1]";
const char* const must_be_real = "a basis function must be real on [0, 1] and at the nodes";
const char* const give_a_value = "give the parameter a value with --param";

/// Returns a single term without tau^k, wave and step: coefficient * exp(rate tau) * factor.
const ExactTerm* only_term(const ExactFunction& function) {
    if (function.terms().size() != 1) return nullptr;
    const ExactTerm& term = function.terms().front();
    const bool fits = term.power == 0 && term.wave == ExactTerm::Wave::none && !term.step;
    return fits ? &term : nullptr;
}

/// Parts of a function: slope*tau + offset + rest.
struct Affine {
    Number slope, offset;
    ExactFunction rest;
};

Affine affine(const ExactFunction& function) {
    Affine result;
    for (const ExactTerm& term : function.terms()) {
        if (term.is_monomial() && term.power <= 1) {
            (term.power == 1 ? result.slope : result.offset) = term.coefficient;
        }
    }
    result.rest = function + ExactFunction(NumberPolynomial{-result.offset, -result.slope});
    return result;
}

ExactFunction times(const Number& factor, const ExactFunction& function) {
    return ExactFunction(factor) * function;
}

/// Returns exp(r log L) as L^r.
std::optional<ExactFunction> exponential_of_logarithm(const ExactTerm& term) {
    if (term.power != 0 || !term.rate.is_zero() || term.wave != ExactTerm::Wave::none) return {};
    if (term.factor == nullptr) return {};
    const auto exponent = small_ratio(term.coefficient);
    const auto* linear = std::get_if<LinearPower>(&term.factor->what);
    const bool fits =
        exponent && linear != nullptr && linear->exponent.above == 0 && linear->logs == 1;
    if (!fits) return std::nullopt;
    return ExactFunction(make_factor(LinearPower{linear->offset, linear->sign, *exponent, 0}));
}

std::string singular(const Domain& domain) {
    return "the function is not defined on all of " + domain.text() + ": ";
}

[[noreturn]] void cannot_decide(const std::string& what, const std::string& where) {
    throw MathError("cannot decide whether " + what + " has a zero " + where, {},
                    "bounds tell zeros only where the sign changes, or at simple fractions");
}

}  // namespace

void FunctionComposition::check_ready(const ExactFunction& function) const {
    if (function.has_steps()) {
        throw InputError("a piecewise function inside another function is not built yet", {},
                         "sums of B-splines and their products with other functions are");
    }
    if (function.has_parameters()) {
        throw InputError("a function of this kind with a free parameter is not built yet", {},
                         give_a_value);
    }
    if (!domain_) {
        throw InputError("a function of this kind at nodes with a free parameter is not built yet",
                         {}, give_a_value);
    }
}

void FunctionComposition::check_no_zero(const ExactFunction& function, const char* what) const {
    const Signs found = signs(function, *domain_, ground_);
    if (const auto place = found.zero(*domain_)) {
        throw MathError(singular(*domain_) + what + " is 0 " + *place, {},
                        "a quotient must have a value everywhere as it is written");
    }
    if (found.undecided) cannot_decide(what, *found.undecided);
}

/// Refuses an argument that is negative somewhere or zero between the ends.
Signs FunctionComposition::positive(const ExactFunction& function, const std::string& what,
                                    bool infinite_at_zero) const {
    const std::string not_real =
        "the function is not real on all of " + domain_->text() + ": " + what;
    if (const auto place = negative_place(function, *domain_)) {
        throw MathError(not_real + " is negative " + *place, {}, must_be_real);
    }
    const Signs found = signs(function, *domain_, ground_);
    if (found.inner_zero) {
        if (found.changes) {
            throw MathError(not_real + " changes its sign " + *found.inner_zero, {}, must_be_real);
        }
        const std::string zero = what + " is 0 " + *found.inner_zero;
        if (infinite_at_zero) {
            throw MathError(singular(*domain_) + zero, {}, must_be_integrable);
        }
        throw InputError(zero + ", and a function with such a place between the ends of " +
                         domain_->text() + " is not built yet");
    }
    if (found.undecided) cannot_decide(what, *found.undecided);
    return found;
}

std::optional<std::string> FunctionComposition::zero_of(const LinearPower& factor) const {
    for (const Number& end : {domain_->low, domain_->high}) {
        if (value_at(factor.line(), end).is_zero()) return at_tau(end);
    }
    return std::nullopt;
}

std::optional<ExactFunction> FunctionComposition::simple_reciprocal(const ExactFunction& f) const {
    const ExactTerm* const term = only_term(f);
    if (term == nullptr) return std::nullopt;
    const ExactFunction rest =
        times(Number(1) / term->coefficient, ExactFunction::exponential(-term->rate));
    if (term->factor == nullptr) return rest;
    if (const auto* call = std::get_if<Call>(&term->factor->what)) {
        if (call->name != "exp") return std::nullopt;
        return rest * call_of("exp", times(Number(-1), call->argument));
    }
    if (const auto* power = std::get_if<Power>(&term->factor->what)) {
        if (power->exponent.is_integer()) return std::nullopt;
        return rest * root(power->base, -power->exponent);
    }
    const auto* linear = std::get_if<LinearPower>(&term->factor->what);
    if (linear == nullptr || linear->logs != 0) return std::nullopt;
    LinearPower inverse = *linear;
    inverse.exponent = -linear->exponent;
    const auto zero = zero_of(*linear);
    if (zero && inverse.exponent.above <= -inverse.exponent.below) return std::nullopt;
    return rest * ExactFunction(make_factor(inverse));
}

/// Returns 1/f as a sum of partial fractions. A sum of partial fractions is N/D, where D is the
/// product of their denominators. So 1/f is D/N, again a sum of partial fractions, over the factors
/// of N.
std::optional<ExactFunction>
FunctionComposition::rational_reciprocal(const ExactFunction& f) const {
    NumberPolynomial numerator;
    NumberPolynomial denominator{Number(1)};
    for (const ExactTerm& term : f.terms()) {
        if (term.wave != ExactTerm::Wave::none || !term.rate.is_zero()) return std::nullopt;
        NumberPolynomial above(term.power + 1);
        above.back() = term.coefficient;
        NumberPolynomial below{Number(1)};
        if (term.factor != nullptr) {
            const auto pole = as_pole(*term.factor);
            if (!pole) return std::nullopt;
            below = power_of(pole->polynomial, pole->order);
        }
        // N/D + above/below, without the part of `below` that D has already
        NumberPolynomial common = gcd(denominator, below);
        const NumberPolynomial more = divide(below, common).quotient;
        const NumberPolynomial other = divide(denominator, common).quotient;
        numerator = sum(product(numerator, more), product(above, other));
        denominator = product(denominator, more);
    }
    const auto factors = factorize(numerator, ground_);
    if (!factors) return std::nullopt;
    ExactFunction result = times(Number(1) / factors->factor, ExactFunction(denominator));
    for (const auto& [part, multiplicity] : factors->parts) {
        result = result * partial_fraction(part, multiplicity, domain_->middle());
    }
    return result;
}

ExactFunction FunctionComposition::reciprocal(const ExactFunction& divisor) const {
    const ExactTerm* const term = only_term(divisor);
    if (term == nullptr || term->factor != nullptr) check_ready(divisor);
    if (const auto simple = simple_reciprocal(divisor)) return *simple;
    check_no_zero(divisor, "this divisor");
    if (const auto rational = rational_reciprocal(divisor)) return *rational;
    return ExactFunction(make_factor(Power{divisor, {-1, 1}}));
}

/// Returns (a tau + b)^exponent.
ExactFunction FunctionComposition::root_of_line(const NumberPolynomial& line,
                                                const Ratio& exponent) const {
    LinearPower factor = line_through(scaled(line, Number(1) / line[1]), domain_->middle());
    factor.exponent = exponent;
    const Number size = factor.sign < 0 ? -line[1] : line[1];
    return times(power(size, exponent, ground_), ExactFunction(make_factor(factor)));
}

std::optional<ExactFunction> FunctionComposition::simple_root(const ExactFunction& base,
                                                              const Ratio& exponent) const {
    const ExactTerm* const term = only_term(base);
    if (term == nullptr || term->coefficient.sign() < 0) return std::nullopt;
    ExactFunction factor{Number(1)};
    if (term->factor != nullptr) {
        if (const auto* linear = std::get_if<LinearPower>(&term->factor->what)) {
            if (linear->logs != 0) return std::nullopt;
            LinearPower next = *linear;
            next.exponent = linear->exponent * exponent;
            factor = ExactFunction(make_factor(next));
        } else if (const auto* call = std::get_if<Call>(&term->factor->what)) {
            if (call->name != "exp") return std::nullopt;
            factor = call_of("exp", times(to_number(exponent), call->argument));
        } else {
            return std::nullopt;
        }
    }
    return times(power(term->coefficient, exponent, ground_),
                 ExactFunction::exponential(term->rate * to_number(exponent)) * factor);
}

ExactFunction FunctionComposition::root(const ExactFunction& base, const Ratio& exponent) const {
    if (const auto constant = base.constant()) {
        if (exponent.below != 2 && constant->has_parameters()) {
            throw InputError("a root of a free parameter is not built yet", {}, give_a_value);
        }
        if (exponent.below != 2 && constant->sign() < 0) {
            throw MathError("this root of a negative number is not real");
        }
        return ExactFunction(power(*constant, exponent, ground_));
    }
    check_ready(base);
    if (auto simple = simple_root(base, exponent)) return *simple;
    const Signs found = positive(base, "the argument of this root", exponent.above < 0);
    const auto zero = found.zero(*domain_);
    if (zero && exponent.above <= -exponent.below) {
        throw MathError(singular(*domain_) + "the base of this negative power is 0 " + *zero, {},
                        must_be_integrable);
    }
    if (base.is_polynomial()) {
        const NumberPolynomial polynomial = base.coefficients();
        bool exact = true;
        for (const Number& coefficient : polynomial) exact = exact && is_exact(coefficient);
        if (exact && polynomial.size() == 2) return root_of_line(polynomial, exponent);
        // The integral of quadratic^(-1/2) has a closed form.
        const bool closed = exact && polynomial.size() == 3 && exponent == Ratio{-1, 2};
        if (closed) return ExactFunction(make_factor(Power{base, exponent}));
    }
    if (zero && exponent.above < 0) {
        throw InputError("the integral of a root with this singularity " + *zero +
                         " is not built yet");
    }
    return ExactFunction(make_factor(Power{base, exponent}));
}

ExactFunction FunctionComposition::exponential(const ExactFunction& argument) const {
    const Affine parts = affine(argument);
    ExactFunction known = times(ground_.exp(parts.offset), ExactFunction::exponential(parts.slope));
    if (parts.rest.terms().empty()) return known;
    check_ready(argument);
    ExactFunction rest;
    for (const ExactTerm& term : parts.rest.terms()) {
        if (auto power = exponential_of_logarithm(term)) {
            known = known * *power;
        } else {
            rest = rest + ExactFunction(term);
        }
    }
    return known * call_of("exp", rest);
}

ExactFunction FunctionComposition::wave(bool cosine, const ExactFunction& argument) const {
    const Affine line = affine(argument);
    if (!line.rest.terms().empty()) {
        check_ready(argument);
        return call_of(cosine ? "cos" : "sin", argument);
    }
    const Number cos = ground_.cos(line.offset);
    const Number sin = ground_.sin(line.offset);
    if (cosine) {
        return times(cos, ExactFunction::cosine(line.slope)) +
               times(-sin, ExactFunction::sine(line.slope));
    }
    return times(sin, ExactFunction::cosine(line.slope)) +
           times(cos, ExactFunction::sine(line.slope));
}

/// Returns the logarithm of a product as the sum of logarithms, for factors that are positive.
ExactFunction FunctionComposition::logarithm(const ExactFunction& argument) const {
    check_ready(argument);
    const ExactTerm* const term = only_term(argument);
    if (term != nullptr && term->coefficient.sign() > 0) {
        const ExactFunction known(NumberPolynomial{ground_.log(term->coefficient), term->rate});
        if (term->factor == nullptr) return known;
        const auto* linear = std::get_if<LinearPower>(&term->factor->what);
        if (linear != nullptr && linear->logs == 0) {
            LinearPower log{linear->offset, linear->sign, {0, 1}, 1};
            return known + times(to_number(linear->exponent), ExactFunction(make_factor(log)));
        }
        const auto* call = std::get_if<Call>(&term->factor->what);
        if (call != nullptr && call->name == "exp") return known + call->argument;
    }
    const Signs found = positive(argument, "the argument of this logarithm", true);
    const auto factors = argument.is_polynomial() ? factorize(argument.coefficients(), ground_)
                                                  : std::optional<Factorization>();
    if (factors) {
        Number size = factors->factor;
        ExactFunction result;
        for (const auto& [part, multiplicity] : factors->parts) {
            const Number count(static_cast<long>(multiplicity));
            const bool positive_inside = value_at(part, domain_->middle()).sign() > 0;
            if (!positive_inside && multiplicity % 2 == 1) size = -size;
            if (part.size() == 2) {
                LinearPower log = line_through(part, domain_->middle());
                log.exponent = {0, 1};
                log.logs = 1;
                result = result + times(count, ExactFunction(make_factor(log)));
            } else {
                const Number sign(positive_inside ? 1 : -1);
                result = result + times(count, call_of("log", ExactFunction(scaled(part, sign))));
            }
        }
        return result + ExactFunction(ground_.log(size));
    }
    if (const auto zero = found.zero(*domain_)) {
        throw InputError("the integral of a logarithm with this singularity " + *zero +
                         " is not built yet");
    }
    return call_of("log", argument);
}

ExactFunction FunctionComposition::tangent(const ExactFunction& argument) const {
    check_ready(argument);
    check_no_zero(wave(true, argument), "the cosine below this tangent");
    return call_of("tan", argument);
}

/// Returns (log(1+x) - log(1-x))/2.
ExactFunction FunctionComposition::area_tangent(const ExactFunction& argument) const {
    check_ready(argument);
    const ExactFunction one{Number(1)};
    const ExactFunction above = one + argument;
    const ExactFunction below = one + times(Number(-1), argument);
    static_cast<void>(positive(above, "1+x for the argument x of this atanh", true));
    static_cast<void>(positive(below, "1-x for the argument x of this atanh", true));
    const Number half = Number(1) / Number(2);
    return times(half, logarithm(above)) + times(-half, logarithm(below));
}

/// Returns the cube root of x, or minus that of -x, by the sign of x.
ExactFunction FunctionComposition::cube_root(const ExactFunction& argument) const {
    check_ready(argument);
    const Signs found = signs(argument, *domain_, ground_);
    if (found.undecided) cannot_decide("the argument of this cbrt", *found.undecided);
    if (found.inner_zero) {
        throw InputError("the argument of this cbrt is 0 " + *found.inner_zero +
                         ", and a function with such a place between the ends of " +
                         domain_->text() + " is not built yet");
    }
    const Number sign(argument.at(domain_->middle(), ground_).sign());
    return times(sign, root(times(sign, argument), {1, 3}));
}

/// Returns functions that are called by their name: those that are real everywhere, asin, acos and
/// acosh.
ExactFunction FunctionComposition::called(const std::string& name,
                                          const ExactFunction& argument) const {
    check_ready(argument);
    const ExactFunction one{Number(1)};
    switch (find_function(name)->domain) {
    case RealDomain::everywhere: break;
    case RealDomain::up_to_one:
        static_cast<void>(positive(one + times(Number(-1), argument * argument),
                                   "1-x^2 for the argument x of this " + name, false));
        break;
    case RealDomain::from_one:
        static_cast<void>(positive(argument + times(Number(-1), one),
                                   "x-1 for the argument x of this " + name, false));
        break;
    default: HVI_CHECK(false);
    }
    return call_of(name, argument);
}

ExactFunction FunctionComposition::call(const std::string& name,
                                        const ExactFunction& argument) const {
    if (const auto constant = argument.constant()) {
        return ExactFunction(elementary(name, *constant, ground_));
    }
    if (name == "exp") return exponential(argument);
    if (name == "cos" || name == "sin") return wave(name == "cos", argument);
    if (name == "log") return logarithm(argument);
    if (name == "tan") return tangent(argument);
    if (name == "cosh" || name == "sinh") {
        const Number half = Number(1) / Number(2);
        return times(half, exponential(argument)) +
               times(name == "cosh" ? half : -half, exponential(times(Number(-1), argument)));
    }
    if (name == "log10") { return times(Number(1) / ground_.log(Number(10)), logarithm(argument)); }
    if (name == "atanh") return area_tangent(argument);
    if (name == "cbrt") return cube_root(argument);
    return called(name, argument);
}

/// Place where a factor is infinite, and whether its integral is infinite too.
struct FunctionComposition::Singularity {
    std::string place;
    bool integrable;
};

std::optional<FunctionComposition::Singularity>
FunctionComposition::singularity(const Factor& factor) const {
    if (const auto* linear = std::get_if<LinearPower>(&factor.what)) {
        if (linear->exponent.above >= 0 && linear->logs == 0) return std::nullopt;
        const auto zero = zero_of(*linear);
        const bool integrable = linear->exponent.above > -linear->exponent.below;
        return zero ? std::optional(Singularity{*zero, integrable}) : std::nullopt;
    }
    const auto* power = std::get_if<Power>(&factor.what);
    if (power == nullptr || power->exponent.is_integer() || power->exponent.above >= 0) return {};
    for (const Number& end : {domain_->low, domain_->high}) {
        if (power->base.at(end, ground_).known_zero() != true) continue;
        return Singularity{at_tau(end), power->exponent.above > -power->exponent.below};
    }
    return std::nullopt;
}

void FunctionComposition::check_integrable(const ExactFunction& function) const {
    for (const ExactTerm& term : function.terms()) {
        if (term.factor == nullptr) continue;
        const auto* product = std::get_if<Product>(&term.factor->what);
        const auto* linear = std::get_if<LinearPower>(&term.factor->what);
        const bool alone = term.wave == ExactTerm::Wave::none && term.rate.is_zero();
        const bool built = product == nullptr && (alone || (linear != nullptr && !linear->logs));
        for (const FactorPointer& factor :
             product != nullptr ? product->factors : std::vector{term.factor}) {
            const auto found = singularity(*factor);
            if (!found) continue;
            if (!found->integrable && product == nullptr) {
                throw MathError("the function is not integrable on " + domain_->text() +
                                    ": its integral is infinite " + found->place,
                                {}, must_be_integrable);
            }
            if (!built) {
                throw InputError("the integral of a product with this singularity " + found->place +
                                 " is not built yet");
            }
        }
    }
}

}  // namespace hvi::gen
