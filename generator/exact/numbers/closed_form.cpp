// Expressions for people, from the normal form of a field element.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "generator/exact/numbers/radicals.hpp"
#include "generator/exact/numbers/written_fraction.hpp"

namespace hvi::gen {

namespace {

Expression power_of(const Expression& base, int exponent) {
    return exponent == 1 ? base : Expression::power(base, Expression::integer(exponent));
}

/// Returns whether it is a positive integer.
bool is_natural(const Element& element) {
    if (!element.is_rational()) return false;
    const Rational value = element.rational();
    return value.is_integer() && value.sign() > 0;
}

/// Returns the transcendental part of a term; exponentials are collected into one, exp(1) is e.
std::vector<Expression> transcendental_factors(const std::vector<int>& powers, const Field* field) {
    std::vector<Expression> factors;
    Element exponent;
    for (std::size_t i = 0; i < powers.size(); ++i) {
        if (powers[i] == 0) continue;
        const Transcendental& generator = field->transcendentals()[i];
        if (generator.exponent) {
            exponent = exponent + *generator.exponent * Element(powers[i]);
        } else {
            factors.push_back(power_of(generator.form, powers[i]));
        }
    }
    if (exponent.is_zero()) return factors;
    const Expression e = Expression::symbol("e");
    if (is_natural(exponent)) {
        factors.push_back(power_of(e, static_cast<int>(exponent.rational().to_long())));
    } else {
        factors.push_back(Expression::call("exp", {closed_form(exponent)}));
    }
    return factors;
}

Expression integer_form(const Integer& value) { return Expression::rational(value.text(), "1"); }

/// Returns cos(half_turns * pi).
Expression cosine_form(const Rational& half_turns) {
    std::vector<Expression> angle{Expression::symbol("pi")};
    if (half_turns.numerator() != 1) {
        angle.insert(angle.begin(), integer_form(half_turns.numerator()));
    }
    angle.push_back(Expression::reciprocal(integer_form(half_turns.denominator())));
    return Expression::call("cos", {Expression::product(std::move(angle))});
}

void append_cosines_and_sines(std::vector<Expression>& factors, const Monomial& monomial,
                              const Field* field) {
    for (std::size_t i = 0; i < monomial.size(); ++i) {
        if (monomial[i] == 0) continue;
        const Algebraic& generator = field->algebraic(i);
        if (generator.kind == Algebraic::Kind::sine) factors.push_back(generator.form);
        if (generator.kind == Algebraic::Kind::cosine) {
            factors.push_back(cosine_form(Rational(monomial[i]) / generator.denominator));
        }
    }
}

/// A factor of a product with the key of its place: symbols and their powers come first, then
/// functions, each by its text.
struct PlacedFactor {
    std::tuple<bool, std::string, std::string> place;
    Expression factor;
};

std::vector<PlacedFactor> with_places(std::vector<Expression> factors) {
    std::vector<PlacedFactor> placed;
    for (Expression& factor : factors) {
        const bool is_power = factor.kind == Expression::Kind::power;
        const Expression& base = is_power ? factor.arguments[0] : factor;
        std::tuple place(base.kind == Expression::Kind::call, to_text(base), to_text(factor));
        placed.push_back({std::move(place), std::move(factor)});
    }
    return placed;
}

/// Returns the factors of both in their places.
std::vector<Expression> in_order(const std::vector<PlacedFactor>& some,
                                 const std::vector<PlacedFactor>& others) {
    std::vector<const PlacedFactor*> ordered;
    for (const PlacedFactor& factor : some) { ordered.push_back(&factor); }
    for (const PlacedFactor& factor : others) { ordered.push_back(&factor); }
    std::sort(ordered.begin(), ordered.end(),
              [](const auto* left, const auto* right) { return left->place < right->place; });
    std::vector<Expression> factors;
    for (const PlacedFactor* each : ordered) { factors.push_back(each->factor); }
    return factors;
}

/// The algebraic part of a term: a rational number, and factors.
struct AlgebraicPart {
    Rational number;
    std::vector<PlacedFactor> factors;
};

AlgebraicPart algebraic_part(const Monomial& monomial, const Field* field) {
    Radicals roots = radicals(monomial, field);
    append_cosines_and_sines(roots.factors, monomial, field);
    return {roots.factor, with_places(std::move(roots.factors))};
}

/// Makes expressions of terms. The form of a product of generators is asked for many times, and
/// computed once.
class Writer {
public:
    explicit Writer(const Field* field) : field_(field) {}

    /// Returns one term with its sign; `divided_by` are powers of transcendental generators below
    /// the line.
    [[nodiscard]] Expression term(const WrittenTerm& term, const Rational& denominator,
                                  const std::vector<int>& divided_by);
    [[nodiscard]] Expression sum(const std::vector<WrittenTerm>& terms, const Rational& denominator,
                                 const std::vector<int>& divided_by);
    /// Returns the sum with the terms in their order.
    [[nodiscard]] Expression ordered_sum(const std::vector<WrittenTerm>& terms,
                                         const Rational& denominator,
                                         const std::vector<int>& divided_by);
    /// Returns the sum written out, or with the common factor of its terms in front; the shorter.
    [[nodiscard]] Expression factored(const std::vector<WrittenTerm>& terms);
    /// Returns numerator/denominator under one line.
    [[nodiscard]] Expression quotient(const WrittenFraction& fraction);

private:
    [[nodiscard]] const AlgebraicPart& algebraic(const Monomial& monomial) {
        const auto [position, is_new] = algebraic_.try_emplace(monomial);
        if (is_new) { position->second = algebraic_part(monomial, field_); }
        return position->second;
    }
    [[nodiscard]] const std::vector<PlacedFactor>& transcendental(const std::vector<int>& powers) {
        const auto [position, is_new] = transcendental_.try_emplace(powers);
        if (is_new) { position->second = with_places(transcendental_factors(powers, field_)); }
        return position->second;
    }
    [[nodiscard]] Expression line(const WrittenFraction& fraction) {
        return Expression::product(
            {factored(fraction.numerator), Expression::reciprocal(factored(fraction.denominator))});
    }

    const Field* field_;
    std::map<Monomial, AlgebraicPart> algebraic_;
    std::map<std::vector<int>, std::vector<PlacedFactor>> transcendental_;
};

Expression Writer::term(const WrittenTerm& term, const Rational& denominator,
                        const std::vector<int>& divided_by) {
    const AlgebraicPart& roots = algebraic(term.monomial);
    const Rational coefficient = term.coefficient * roots.number / denominator;
    std::vector<int> powers = term.powers;
    std::vector<int> below(powers.size());
    for (std::size_t i = 0; i < powers.size(); ++i) {
        const int power = powers[i] - (i < divided_by.size() ? divided_by[i] : 0);
        powers[i] = std::max(power, 0);
        below[i] = std::max(-power, 0);
    }
    std::vector<Expression> factors = in_order(transcendental(powers), roots.factors);
    const Integer numerator = abs(coefficient).numerator();
    if (numerator != 1 || factors.empty()) {
        factors.insert(factors.begin(), integer_form(numerator));
    }
    std::vector<Expression> divisors;
    for (const PlacedFactor& each : transcendental(below)) { divisors.push_back(each.factor); }
    if (!coefficient.is_integer()) {
        divisors.insert(divisors.begin(), integer_form(coefficient.denominator()));
    }
    if (!divisors.empty()) factors.push_back(Expression::reciprocal(Expression::product(divisors)));
    Expression product = Expression::product(std::move(factors));
    return coefficient.sign() < 0 ? Expression::negation(std::move(product)) : product;
}

Expression Writer::ordered_sum(const std::vector<WrittenTerm>& terms, const Rational& denominator,
                               const std::vector<int>& divided_by) {
    std::vector<Expression> summands;
    for (const WrittenTerm& summand : terms) {
        summands.push_back(term(summand, denominator, divided_by));
    }
    return Expression::sum(std::move(summands));
}

/// Writes a sum. A sum does not begin with a minus sign where it need not: 1-cos(w), not -cos(w)+1.
Expression Writer::sum(const std::vector<WrittenTerm>& terms, const Rational& denominator,
                       const std::vector<int>& divided_by) {
    std::vector<WrittenTerm> ordered = terms;
    const auto is_positive = [](const WrittenTerm& term) { return !is_negative(term); };
    const auto positive = std::find_if(ordered.begin(), ordered.end(), is_positive);
    if (positive != ordered.end()) std::rotate(ordered.begin(), positive, positive + 1);
    return ordered_sum(ordered, denominator, divided_by);
}

const Expression& shorter(const Expression& left, const Expression& right) {
    return to_text(right).size() < to_text(left).size() ? right : left;
}

Expression Writer::factored(const std::vector<WrittenTerm>& terms) {
    Expression expanded = sum(terms, 1, {});
    if (terms.size() < 2) return expanded;
    WrittenTerm common{0, terms.front().powers, {}};
    for (const WrittenTerm& summand : terms) {
        common.coefficient = gcd(common.coefficient, summand.coefficient);
        for (std::size_t i = 0; i < common.powers.size(); ++i) {
            common.powers[i] = std::min(common.powers[i], summand.powers[i]);
        }
    }
    const bool has_powers = std::any_of(common.powers.begin(), common.powers.end(),
                                        [](int power) { return power != 0; });
    if (!has_powers && common.coefficient == 1) return expanded;
    std::vector<WrittenTerm> rest = terms;
    for (WrittenTerm& summand : rest) {
        summand.coefficient /= common.coefficient;
        for (std::size_t i = 0; i < common.powers.size(); ++i) {
            summand.powers[i] -= common.powers[i];
        }
    }
    return shorter(expanded, Expression::product({term(common, 1, {}), sum(rest, 1, {})}));
}

/// Writes a quotient. NOTE: where all signs are negative the quotient has its sign in front.
/// Otherwise the signs above and below are chosen so that the first term above is positive, unless
/// that made a sum below begin with a minus sign.
Expression Writer::quotient(const WrittenFraction& fraction) {
    WrittenFraction flipped = fraction;
    negate(flipped.numerator);
    const auto& [above, below] = fraction;
    if (std::all_of(above.begin(), above.end(), is_negative)) {
        return Expression::negation(line(flipped));
    }
    negate(flipped.denominator);
    const bool flips =
        is_negative(above.front()) && std::any_of(below.begin(), below.end(), is_negative);
    return line(flips ? flipped : fraction);
}

/// Returns the number of a parameter among the transcendental generators, or their count.
std::size_t index_of(const std::string& parameter, const Field* field) {
    if (field == nullptr) { return 0; }
    const auto& generators = field->transcendentals();
    const auto found = std::find_if(generators.begin(), generators.end(), [&](const auto& each) {
        return each.is_parameter && each.form == Expression::symbol(parameter);
    });
    return static_cast<std::size_t>(found - generators.begin());
}

}  // namespace

Expression expanded_form(const Element& argument, const std::string& parameter) {
    if (argument.is_zero()) { return Expression::integer(0); }
    const std::size_t index = index_of(parameter, argument.field());
    const auto power = [&](const WrittenTerm& term) {
        return index < term.powers.size() ? term.powers[index] : 0;
    };
    WrittenFraction form = written_fraction(argument);
    Writer write(argument.field());
    const WrittenTerm& divisor = form.denominator.front();
    if (form.denominator.size() == 1 && power(divisor) == 0) {
        std::stable_sort(
            form.numerator.begin(), form.numerator.end(),
            [&](const WrittenTerm& a, const WrittenTerm& b) { return power(a) < power(b); });
        return write.ordered_sum(form.numerator, divisor.coefficient, divisor.powers);
    }
    const auto falls = [&](const WrittenTerm& a, const WrittenTerm& b) {
        return power(a) > power(b);
    };
    std::stable_sort(form.numerator.begin(), form.numerator.end(), falls);
    std::stable_sort(form.denominator.begin(), form.denominator.end(), falls);
    if (is_negative(form.denominator.front())) {
        negate(form.numerator);
        negate(form.denominator);
    }
    const bool negative = std::all_of(form.numerator.begin(), form.numerator.end(), is_negative);
    if (negative) { negate(form.numerator); }
    Expression quotient =
        Expression::product({write.ordered_sum(form.numerator, 1, {}),
                             Expression::reciprocal(write.ordered_sum(form.denominator, 1, {}))});
    return negative ? Expression::negation(std::move(quotient)) : quotient;
}

int leading_sign(const Element& argument) {
    return written_fraction(argument).numerator.front().coefficient.sign() < 0 ? -1 : 1;
}

Expression closed_form(const Element& argument) {
    if (argument.is_zero()) return Expression::integer(0);
    const Field* const field = argument.field();
    const WrittenFraction form = written_fraction(argument);
    Writer write(field);
    if (form.denominator.size() > 1) return write.quotient(form);
    const WrittenTerm& divisor = form.denominator.front();
    const Expression termwise = write.sum(form.numerator, divisor.coefficient, divisor.powers);
    const bool divides = std::any_of(divisor.powers.begin(), divisor.powers.end(),
                                     [](int power) { return power != 0; });
    if (!divides) return termwise;
    return shorter(write.quotient(form), termwise);
}

}  // namespace hvi::gen
