// Exponentials, logarithms, cosines and sines of exact numbers, as generators of the field.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <flint/arith.h>

#include <algorithm>
#include <utility>

#include "generator/exact/numbers/field.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

/// Limit of the powers of a generator. Higher powers make expressions that nobody wants to read,
/// and slow ones: the value is left to an enclosure.
constexpr long most_times = 128;

/// Largest n for which half turns pi/n are written with square roots.
constexpr long most_constructible = 24;

/// Largest degree of cos(pi/n) over Q, for other n, at which it becomes a generator.
constexpr unsigned most_cosine_degree = 6;

/// Returns a function of Arb at a field element. It is only called where the element has a value.
std::function<Ball(Precision)> applied(void (*function)(arb_t, const arb_t, slong),
                                       const Element& argument) {
    return [function, argument](Precision bits) {
        Ball value = enclosure(argument, bits);
        function(value.get(), value.get(), bits);
        return value;
    };
}

/// Returns a value that keeps the tightest enclosure asked for.
std::function<Ball(Precision)> remembered(std::function<Ball(Precision)> value) {
    if (!value) return value;
    return [value = std::move(value), memory = std::make_shared<TightestBall>()](Precision bits) {
        return memory->at(bits, value);
    };
}

Field::CosSin product(const Field::CosSin& left, const Field::CosSin& right) {
    return {left.cos * right.cos - left.sin * right.sin,
            left.sin * right.cos + left.cos * right.sin};
}

/// Returns the even n for which cos(pi/n) reaches the cosine and sine of an angle, see
/// Field::cyclotomic.
Integer even_denominator(const Rational& half_turns) { return lcm(half_turns.denominator(), 2); }

/// Returns cos and sin of n times an angle.
Field::CosSin times(Field::CosSin angle, long n) {
    if (n < 0) angle.sin = -angle.sin;
    Field::CosSin result{Element(1), Element()};
    for (long rest = std::abs(n); rest != 0; rest /= 2) {
        if (rest % 2 == 1) result = product(result, angle);
        if (rest > 1) angle = product(angle, angle);
    }
    return result;
}

}  // namespace

std::optional<Element> Field::transcendental(const std::string& key, Transcendental generator) {
    const bool is_full = transcendentals_.size() + 1 >= IntegerMultivariate::most_variables;
    if (is_full && key != "pi" && by_key_.find(key) == by_key_.end()) return std::nullopt;
    const auto [position, is_new] = by_key_.try_emplace(key, transcendentals_.size());
    if (is_new) {
        generator.value = remembered(std::move(generator.value));
        transcendentals_.push_back(std::move(generator));
    }
    return Element::variable(position->second, this);
}

Element Field::adjoin(Algebraic generator) {
    generator.value = remembered(std::move(generator.value));
    algebraics_.push_back(std::move(generator));
    Monomial monomial(algebraics_.size());
    monomial.back() = 1;
    return Element::product(monomial, this);
}

Element Field::pi() {
    Transcendental generator;
    generator.form = Expression::symbol("pi");
    generator.value = [](Precision bits) {
        Ball result;
        arb_const_pi(result.get(), bits);
        return result;
    };
    return transcendental("pi", std::move(generator)).value();
}

Element Field::parameter(const std::string& name) {
    Transcendental generator;
    generator.form = Expression::symbol(name);
    generator.is_parameter = true;
    const auto symbol = transcendental("parameter " + name, std::move(generator));
    if (!symbol) throw InputError("too many different symbols and constants in one method");
    return *symbol;
}

std::vector<std::string> Field::parameters() const {
    std::vector<std::string> result;
    for (const Transcendental& generator : transcendentals_) {
        if (generator.is_parameter && generator.form.kind == Expression::Kind::symbol) {
            result.push_back(generator.form.name);
        }
    }
    std::sort(result.begin(), result.end());
    return result;
}

std::optional<std::vector<Field::Part>> Field::split(const Element& argument) {
    std::map<std::string, Part> parts;  // by the unit's text, in an order that does not vary
    const auto add = [&](const Element& summand, const Rational& size) {
        const Rational factor = leading_sign(summand) < 0 ? -size : size;
        const Element unit = summand * Element(1 / factor);
        const std::string key = to_text(closed_form(unit));
        const auto [position, is_new] = parts.try_emplace(key, Part{factor, unit, key});
        HVI_CHECK(is_new);
    };
    const auto denominator = argument.denominator().terms();
    if (denominator.size() > 1) return std::nullopt;
    for (const auto& [monomial, coefficient] : argument.numerator()) {
        for (const IntegerMultivariate::Term& term : coefficient.terms()) {
            const Rational size = abs(Rational(term.coefficient)) / denominator.front().coefficient;
            add(Element::quotient({{monomial, IntegerMultivariate::of(term)}},
                                  argument.denominator(), this),
                size);
        }
    }
    std::vector<Part> result;
    for (auto& [key, part] : parts) result.push_back(std::move(part));
    return result;
}

/// NOTE: a denominator may be large, as that of sqrt(525 + 70 sqrt(30))/140 is, where no multiple
/// of the unit is a high power of the generator.
std::optional<Field::Multiple> Field::multiple(const std::string& key, const Rational& factor,
                                               const Rational& largest) {
    const auto known = denominators_.find(key);
    const bool is_new = known == denominators_.end();
    const Multiples before = is_new ? Multiples{factor.denominator(), 0} : known->second;
    const Multiples now{lcm(before.denominator, factor.denominator()),
                        std::max(before.largest, largest)};
    if (now.largest * now.denominator > most_times) return std::nullopt;
    denominators_[key] = now;
    if (now.denominator != before.denominator) throw TooCoarse{denominators_};
    return Multiple{(factor * now.denominator).to_long(), now.denominator};
}

/// Returns p, when the unit is log(p).
std::optional<long> Field::prime_of_logarithm(const Element& unit) const {
    for (std::size_t i = 0; i < transcendentals_.size(); ++i) {
        if (transcendentals_[i].prime != 0 &&
            (unit - Element::variable(i, unit.field())).is_zero()) {
            return transcendentals_[i].prime;
        }
    }
    return std::nullopt;
}

/// Returns p^exponent, where square roots express it.
std::optional<Element> Field::prime_power(long prime, const Rational& exponent) {
    const Rational doubled = exponent * 2;
    if (!doubled.is_integer() || abs(doubled) > most_times) return std::nullopt;
    const bool is_whole = exponent.is_integer();
    const auto root = is_whole ? std::optional(Element(prime)) : sqrt(Element(prime));
    if (!root) return std::nullopt;
    const long times = (is_whole ? exponent : doubled).to_long();
    const Element raised = power(*root, static_cast<unsigned>(std::abs(times)));
    return times < 0 ? inverse(raised) : raised;
}

std::optional<Element> Field::exp(const Element& given) {
    const auto parts = split(given + Element(0, this));
    if (!parts) return std::nullopt;
    Element result(1, this);
    for (const Part& part : *parts) {
        if (const auto prime = prime_of_logarithm(part.unit)) {
            const auto raised = prime_power(*prime, part.factor);
            if (!raised) return std::nullopt;
            result = result * *raised;
            continue;
        }
        const auto exponent = multiple("exp " + part.key, part.factor, abs(part.factor));
        if (!exponent) return std::nullopt;
        const Element unit = part.unit * Element(Rational(1) / exponent->denominator);
        Transcendental generator;
        generator.form = Expression::call("exp", {closed_form(unit)});
        generator.exponent = unit;
        generator.is_parameter = hvi::gen::has_parameters(unit);
        generator.value = applied(arb_exp, unit);
        const auto base = transcendental("exp " + part.key, std::move(generator));
        if (!base) return std::nullopt;
        const Element raised = power(*base, static_cast<unsigned>(std::abs(exponent->times)));
        result = result * (exponent->times < 0 ? inverse(raised) : raised);
    }
    return result;
}

std::optional<Element> Field::log(const Element& argument) {
    if (!argument.is_rational()) return std::nullopt;
    const Rational value = argument.rational();
    if (value.sign() <= 0) throw MathError("the logarithm of a number that is not positive");
    // a sum over primes, whose logarithms are independent over Q
    Element result(0, this);
    for (const auto& [part, weight] :
         {std::pair(value.numerator(), 1), std::pair(value.denominator(), -1)}) {
        Integer rest = part;
        for (long prime = 2; rest != 1; ++prime) {
            if (prime > 1000) return std::nullopt;
            for (; rest.is_multiple_of(prime); rest /= prime) {
                Transcendental generator;
                generator.form = Expression::call("log", {Expression::integer(prime)});
                generator.value = applied(arb_log, Element(prime));
                generator.prime = prime;
                const auto log_prime = transcendental("log " + std::to_string(prime), generator);
                if (!log_prime) return std::nullopt;
                result = result + *log_prime * Element(weight);
            }
        }
    }
    return result;
}

std::optional<Field::CosSin> Field::cos_sin(const Element& given) {
    const auto parts = split(given + Element(0, this));
    if (!parts) return std::nullopt;
    CosSin result{Element(1, this), Element(0, this)};
    for (const Part& part : *parts) {
        const auto rotation = part.key == "pi" ? cos_sin_of_pi(part.factor) : cos_sin_of_part(part);
        if (!rotation) return std::nullopt;
        result = product(result, *rotation);
    }
    return result;
}

std::optional<Field::CosSin> Field::cos_sin_of_part(const Part& part) {
    const auto angle = multiple("cos " + part.key, part.factor, abs(part.factor));
    if (!angle) return std::nullopt;
    const auto known = angles_.find(part.key);
    if (known != angles_.end()) return times(known->second, angle->times);
    if (algebraics_.size() >= most_generators) return std::nullopt;

    const Element unit = part.unit * Element(Rational(1) / angle->denominator);
    const Expression form = closed_form(unit);
    Transcendental cosine;
    cosine.form = Expression::call("cos", {form});
    cosine.is_parameter = hvi::gen::has_parameters(unit);
    cosine.angle = unit;
    cosine.value = applied(arb_cos, unit);
    const auto found = transcendental("cos " + part.key, std::move(cosine));
    if (!found) return std::nullopt;
    const Element& c = *found;
    Algebraic sine;
    sine.kind = Algebraic::Kind::sine;
    sine.reduced = Element(1) - c * c;
    sine.cosine = by_key_.at("cos " + part.key);
    sine.form = Expression::call("sin", {form});
    sine.is_parameter = hvi::gen::has_parameters(unit);
    sine.value = applied(arb_sin, unit);
    const CosSin generators{c, adjoin(std::move(sine))};
    angles_.emplace(part.key, generators);
    return times(generators, angle->times);
}

std::optional<Field::CosSin> Field::cos_sin_of_pi(const Rational& half_turns) {
    const Integer denominator = half_turns.denominator();
    if (denominator > 10000) return std::nullopt;
    // NOTE: cos(pi/18) and sqrt(3) are not independent. Where there is a generator cos(pi/N), every
    // angle that it reaches is written with it.
    const auto common = denominators_.find("cos pi");
    if (common != denominators_.end() &&
        common->second.denominator.is_multiple_of(even_denominator(half_turns))) {
        if (const auto known = cyclotomic(half_turns)) return known;
    }
    const long n = denominator.to_long();
    const Integer times_pi_n = mod(half_turns.numerator(), 2 * denominator);
    if (const auto base = constructible(n)) return times(*base, times_pi_n.to_long());
    return cyclotomic(half_turns);
}

/// Returns cos(pi/n) and sin(pi/n) for n = 2^k, 3*2^k, 5*2^k, 15*2^k: by halving from a few known
/// angles.
std::optional<Field::CosSin> Field::constructible(long n) {
    const auto rational = [this](long p, long q) { return Element(Rational(p) / q, this); };
    if (n > most_constructible) return std::nullopt;
    std::optional<Element> cosine;
    if (n == 1) return CosSin{rational(-1, 1), rational(0, 1)};
    if (n == 2) return CosSin{rational(0, 1), rational(1, 1)};
    if (n == 3) cosine = rational(1, 2);
    if (n == 5) {
        const auto root = sqrt(Element(5));
        if (root) cosine = (rational(1, 1) + *root) * rational(1, 4);
    }
    if (n == 15) {  // pi/15 = 2 pi/5 - pi/3
        const auto fifth = constructible(5);
        const auto third = constructible(3);
        if (!fifth || !third) return std::nullopt;
        return product(times(*fifth, 2), times(*third, -1));
    }
    if (n % 2 == 0) {
        const auto twice = constructible(n / 2);
        if (twice) cosine = sqrt((rational(1, 1) + twice->cos) * rational(1, 2));
    }
    if (!cosine) return std::nullopt;
    const auto sine = sqrt(rational(1, 1) - *cosine * *cosine);
    if (!sine) return std::nullopt;
    return CosSin{*cosine, *sine};
}

/// Returns any other rational multiple of pi, as a polynomial in cos(pi/N), N even: sin(pi p/n) is
/// cos(pi (n - 2p)/(2n)). All such angles of one table share N.
std::optional<Field::CosSin> Field::cyclotomic(const Rational& half_turns) {
    const bool is_first = denominators_.find("cos pi") == denominators_.end();
    const auto common = multiple("cos pi", Rational(1) / even_denominator(half_turns), 1);
    if (!common) return std::nullopt;
    if (is_first && !algebraics_.empty()) throw TooCoarse{denominators_};
    const long n = common->denominator.to_long();

    if (angles_.find("pi") == angles_.end()) {
        // The minimal polynomial of cos(2 pi/(2n)), or, in newer versions of FLINT, of its double,
        // which is monic.
        fmpz_poly_t minimal;
        fmpz_poly_init(minimal);
        arith_cos_minpoly(minimal, 2 * static_cast<ulong>(n));
        const auto degree = static_cast<unsigned>(fmpz_poly_degree(minimal));
        Algebraic cosine;
        cosine.kind = Algebraic::Kind::cosine;
        cosine.degree = degree;
        cosine.denominator = n;
        cosine.value = [n](Precision bits) {
            Ball ball;
            fmpq_t angle;
            fmpq_init(angle);
            fmpq_set_si(angle, 1, static_cast<ulong>(n));
            arb_cos_pi_fmpq(ball.get(), angle, bits);
            fmpq_clear(angle);
            return ball;
        };
        std::vector<Integer> coefficients(degree + 1);
        for (unsigned k = 0; k <= degree; ++k) {
            fmpz_poly_get_coeff_fmpz(coefficients[k].get(), minimal, k);
        }
        fmpz_poly_clear(minimal);
        if (degree > most_cosine_degree) return std::nullopt;
        const std::size_t index = algebraics_.size();
        const Element generator = adjoin(std::move(cosine));
        Element reduced(0, this);
        for (unsigned k = 0; k < degree; ++k) {
            Monomial monomial;
            if (k != 0) {
                monomial.resize(index + 1);
                monomial[index] = k;
            }
            const bool is_of_double = coefficients[degree] == 1;
            const Integer scale = is_of_double ? 1L << (degree - k) : coefficients[degree];
            reduced = reduced -
                      Element::product(monomial, this) * Element(Rational(coefficients[k]) / scale);
        }
        algebraics_[index].reduced = reduced;
        angles_.emplace("pi", CosSin{generator, Element(0, this)});
    }
    const Element& generator = angles_.at("pi").cos;
    const auto cosine_of = [&](const Rational& angle) {  // T_k of the generator, by its recurrence
        const long k = std::abs((angle * n).to_long());
        Element before(1, this);
        Element result = generator;
        if (k == 0) return before;
        for (long i = 1; i < k; ++i) {
            before = std::exchange(result, Element(2) * generator * result - before);
        }
        return result;
    };
    const Integer denominator = half_turns.denominator();
    const Rational turn = Rational(mod(half_turns.numerator(), 2 * denominator)) / denominator;
    return CosSin{cosine_of(turn), cosine_of(Rational(1) / 2 - turn)};
}

}  // namespace hvi::gen
