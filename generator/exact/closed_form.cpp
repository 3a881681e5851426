// From the normal form of a field element to the expression that people read.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <tuple>
#include <utility>

#include "generator/exact/field.hpp"
#include "generator/exact/integers.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

using GiNaC::numeric;

/// coefficient * product of powers of the transcendental generators * algebraic monomial.
struct Term {
    numeric coefficient;
    std::vector<int> powers;
    Monomial monomial;
};

/// (sum of numerator)/(sum of denominator): integer coefficients without a common divisor, the
/// first of the denominator positive, no algebraic generator in the denominator. The terms are
/// sorted by their exponents.
struct Fraction {
    std::vector<Term> numerator;
    std::vector<Term> denominator;
};

/// Sorts terms: by degree, then by their powers of the generators, pi and parameters first, in the
/// order of the generators' texts. NOTE: not in that in which a derivation met them, and
/// exponentials do not count in the degree, since exp(1/2) may be the third power of exp(1/6): so
/// that one number has one text.
class TermOrder {
public:
    explicit TermOrder(const Field* field) : field_(field) {
        if (field == nullptr) { return; }
        std::map<std::tuple<bool, std::string>, std::size_t> transcendentals;
        for (std::size_t i = 0; i < field->transcendentals().size(); ++i) {
            const Expression& form = field->transcendentals()[i].form;
            transcendentals.emplace(
                std::tuple(form.kind != Expression::Kind::symbol, to_text(form)), i);
        }
        for (const auto& [key, index] : transcendentals) { transcendentals_.push_back(index); }
        std::map<std::tuple<Algebraic::Kind, std::size_t, std::string>, std::size_t> algebraics;
        for (std::size_t i = 0; i < field->algebraic_count(); ++i) {
            const std::string text = to_text(field->algebraic(i).form);
            algebraics.emplace(std::tuple(field->algebraic(i).kind, text.size(), text), i);
        }
        for (const auto& [key, index] : algebraics) { algebraics_.push_back(index); }
    }

    void sort(std::vector<Term>& terms) const {
        std::vector<std::pair<Key, Term>> keyed;
        for (Term& term : terms) {
            Key key = key_of(term);
            keyed.emplace_back(std::move(key), std::move(term));
        }
        std::sort(keyed.begin(), keyed.end(),
                  [](const auto& left, const auto& right) { return left.first < right.first; });
        terms.clear();
        for (auto& [key, term] : keyed) { terms.push_back(std::move(term)); }
    }

private:
    using Key = std::tuple<int, std::vector<int>, std::vector<unsigned>>;

    [[nodiscard]] Key key_of(const Term& term) const {
        int degree = 0;
        std::vector<int> powers;
        for (const std::size_t i : transcendentals_) {
            if (!field_->transcendentals()[i].exponent) { degree -= term.powers[i]; }
            powers.push_back(-term.powers[i]);
        }
        std::vector<unsigned> monomial;
        for (const std::size_t i : algebraics_) {
            monomial.push_back(i < term.monomial.size() ? term.monomial[i] : 0);
        }
        return {degree, powers, monomial};
    }

    const Field* field_;
    std::vector<std::size_t> transcendentals_, algebraics_;
};

void append_polynomial(std::vector<Term>& terms, const IntegerMultivariate& polynomial,
                       const Monomial& monomial, const Field* field) {
    const std::size_t count = field == nullptr ? 0 : field->transcendentals().size();
    for (IntegerMultivariate::Term term : polynomial.terms()) {
        term.powers.resize(count);
        terms.push_back(
            {term.coefficient.value(), {term.powers.begin(), term.powers.end()}, monomial});
    }
}

/// Powers of a cosine generator g = cos(pi/n) as cosines of multiple angles,
/// g^k = 2^(1-k) (cos(k pi/n) + k cos((k-2) pi/n) + ...): from here on an exponent k of g stands
/// for cos(k pi/n).
std::vector<Term> with_multiple_angles(const std::vector<Term>& terms, std::size_t index) {
    std::map<std::pair<std::vector<int>, Monomial>, numeric> sums;
    for (const Term& term : terms) {
        const unsigned k = index < term.monomial.size() ? term.monomial[index] : 0;
        for (unsigned j = 0; 2 * j <= k; ++j) {
            Monomial monomial = term.monomial;
            if (k != 0) monomial[index] = k - 2 * j;
            while (!monomial.empty() && monomial.back() == 0) monomial.pop_back();
            const numeric both = 2 * j == k ? 1 : 2;
            const numeric share =
                GiNaC::binomial(numeric(k), numeric(j)) * both / GiNaC::pow(numeric(2), numeric(k));
            sums[{term.powers, monomial}] += term.coefficient * share;
        }
    }
    std::vector<Term> result;
    for (const auto& [key, coefficient] : sums) {
        if (!coefficient.is_zero()) result.push_back({coefficient, key.first, key.second});
    }
    return result;
}

Fraction fraction(const Element& argument) {
    HVI_CHECK(!argument.is_zero());
    Fraction result;
    append_polynomial(result.denominator, argument.denominator(), {}, argument.field());
    for (const auto& [monomial, coefficient] : argument.numerator()) {
        append_polynomial(result.numerator, coefficient, monomial, argument.field());
    }
    for (std::size_t i = 0; i < argument.level(); ++i) {
        if (argument.field()->algebraic(i).kind == Algebraic::Kind::cosine) {
            result.numerator = with_multiple_angles(result.numerator, i);
        }
    }
    const TermOrder order(argument.field());
    order.sort(result.numerator);
    order.sort(result.denominator);

    numeric divisor = 0;
    numeric multiple = 1;
    for (const auto* side : {&result.numerator, &result.denominator}) {
        for (const Term& term : *side) multiple = GiNaC::lcm(multiple, term.coefficient.denom());
    }
    for (const auto* side : {&result.numerator, &result.denominator}) {
        for (const Term& term : *side) divisor = GiNaC::gcd(divisor, term.coefficient * multiple);
    }
    if (result.denominator.front().coefficient.is_negative()) divisor = -divisor;
    for (auto* side : {&result.numerator, &result.denominator}) {
        for (Term& term : *side) term.coefficient *= multiple / divisor;
    }
    return result;
}

/// A rational factor and radicals, equal to a product of root generators.
struct Radicals {
    numeric factor = 1;
    std::vector<Expression> factors;

    [[nodiscard]] std::size_t length() const {
        std::size_t sum = digits(factor).size();
        for (const Expression& radical : factors) sum += to_text(radical).size() + 1;
        return sum;
    }
};

/// Multiplies by sqrt(radicand), squares taken out.
void append_root(Radicals& radicals, const Element& radicand) {
    const Simplified root = simplified_root(radicand);
    radicals.factor *= root.factor;
    if (root.radicand.is_rational() && root.radicand.rational().is_equal(1)) return;
    radicals.factors.push_back(Expression::call("sqrt", {closed_form(root.radicand)}));
}

/// Two ways to write a product of roots: the rational radicands under one root and each nested one
/// by itself, or all under one root; the shorter serves. sqrt(2)*sqrt(3) is sqrt(6), and the two
/// conjugate radicals of gauss:4 multiply to 35*sqrt(105).
Radicals radicals(const Monomial& monomial, const Field* field) {
    if (monomial.empty()) return {};
    Radicals separate;
    Element rational(1);
    Element all(1);
    for (std::size_t i = 0; i < monomial.size(); ++i) {
        if (monomial[i] == 0 || field->algebraic(i).kind != Algebraic::Kind::root) continue;
        const Algebraic& generator = field->algebraic(i);
        all = all * generator.reduced;
        if (generator.reduced.is_rational()) {
            rational = rational * generator.reduced;
        } else {
            separate.factors.push_back(generator.form);
        }
    }
    if (all.is_rational()) {
        Radicals single;
        append_root(single, all);
        return single;
    }
    std::vector<Expression> nested = std::move(separate.factors);
    separate.factors.clear();
    append_root(separate, rational);
    separate.factors.insert(separate.factors.end(), nested.begin(), nested.end());
    if (has_parameters(all)) return separate;
    Radicals single;
    append_root(single, all);
    return single.length() < separate.length() ? single : separate;
}

Expression power_of(const Expression& base, int exponent) {
    return exponent == 1 ? base : Expression::power(base, Expression::integer(exponent));
}

/// The transcendental part of a term; exponentials are collected into one, exp(1) is e.
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
    if (exponent.is_rational() && exponent.rational().is_pos_integer()) {
        factors.push_back(power_of(e, exponent.rational().to_int()));
    } else {
        factors.push_back(Expression::call("exp", {closed_form(exponent)}));
    }
    return factors;
}

Expression integer_form(const numeric& value) { return Expression::rational(digits(value), "1"); }

/// cos(half_turns * pi)
Expression cosine_form(const numeric& half_turns) {
    std::vector<Expression> angle{Expression::symbol("pi")};
    if (!half_turns.numer().is_equal(1)) {
        angle.insert(angle.begin(), integer_form(half_turns.numer()));
    }
    angle.push_back(Expression::reciprocal(integer_form(half_turns.denom())));
    return Expression::call("cos", {Expression::product(std::move(angle))});
}

void negate(std::vector<Term>& terms) {
    for (Term& term : terms) term.coefficient = -term.coefficient;
}

/// Orders the factors of a product: symbols and their powers, then functions, each by its text.
void sort_factors(std::vector<Expression>& factors) {
    using Key = std::tuple<bool, std::string, std::string>;
    std::vector<std::pair<Key, Expression>> keyed;
    for (Expression& factor : factors) {
        const bool is_power = factor.kind == Expression::Kind::power;
        const Expression& base = is_power ? factor.arguments[0] : factor;
        Key key(base.kind == Expression::Kind::call, to_text(base), to_text(factor));
        keyed.emplace_back(std::move(key), std::move(factor));
    }
    std::sort(keyed.begin(), keyed.end(),
              [](const auto& left, const auto& right) { return left.first < right.first; });
    factors.clear();
    for (auto& [key, factor] : keyed) { factors.push_back(std::move(factor)); }
}

bool is_negative(const Term& term) { return term.coefficient.is_negative(); }

/// Makes expressions of terms. What a product of generators looks like is asked for many times, and
/// worked out once.
class Writer {
public:
    explicit Writer(const Field* field) : field_(field) {}

    /// One term with its sign; `divided_by` are powers of transcendental generators below the line.
    [[nodiscard]] Expression term(const Term& term, const numeric& denominator,
                                  const std::vector<int>& divided_by);
    [[nodiscard]] Expression sum(const std::vector<Term>& terms, const numeric& denominator,
                                 const std::vector<int>& divided_by);
    /// The same with the terms in their order.
    [[nodiscard]] Expression ordered_sum(const std::vector<Term>& terms, const numeric& denominator,
                                         const std::vector<int>& divided_by);
    /// The sum written out, or with what its terms have in common in front; the shorter.
    [[nodiscard]] Expression factored(const std::vector<Term>& terms);
    /// numerator/denominator under one line.
    [[nodiscard]] Expression quotient(const Fraction& fraction);

private:
    [[nodiscard]] const Radicals& roots(const Monomial& monomial) {
        const auto [position, is_new] = roots_.try_emplace(monomial);
        if (is_new) { position->second = radicals(monomial, field_); }
        return position->second;
    }
    [[nodiscard]] const std::vector<Expression>& transcendentals(const std::vector<int>& powers) {
        const auto [position, is_new] = transcendentals_.try_emplace(powers);
        if (is_new) { position->second = transcendental_factors(powers, field_); }
        return position->second;
    }
    [[nodiscard]] Expression line(const Fraction& fraction) {
        return Expression::product(
            {factored(fraction.numerator), Expression::reciprocal(factored(fraction.denominator))});
    }

    const Field* field_;
    std::map<Monomial, Radicals> roots_;
    std::map<std::vector<int>, std::vector<Expression>> transcendentals_;
};

Expression Writer::term(const Term& term, const numeric& denominator,
                        const std::vector<int>& divided_by) {
    const Radicals& radicals = roots(term.monomial);
    const numeric coefficient = term.coefficient * radicals.factor / denominator;
    std::vector<int> powers = term.powers;
    std::vector<int> below(powers.size());
    for (std::size_t i = 0; i < powers.size(); ++i) {
        const int power = powers[i] - (i < divided_by.size() ? divided_by[i] : 0);
        powers[i] = std::max(power, 0);
        below[i] = std::max(-power, 0);
    }
    std::vector<Expression> factors = transcendentals(powers);
    factors.insert(factors.end(), radicals.factors.begin(), radicals.factors.end());
    for (std::size_t i = 0; i < term.monomial.size(); ++i) {
        if (term.monomial[i] == 0) continue;
        const Algebraic& generator = field_->algebraic(i);
        if (generator.kind == Algebraic::Kind::sine) factors.push_back(generator.form);
        if (generator.kind == Algebraic::Kind::cosine) {
            factors.push_back(cosine_form(numeric(term.monomial[i], generator.denominator)));
        }
    }
    sort_factors(factors);
    const numeric numerator = GiNaC::abs(coefficient.numer());
    if (!numerator.is_equal(1) || factors.empty()) {
        factors.insert(factors.begin(), integer_form(numerator));
    }
    std::vector<Expression> divisors = transcendentals(below);
    if (!coefficient.denom().is_equal(1)) {
        divisors.insert(divisors.begin(), integer_form(coefficient.denom()));
    }
    if (!divisors.empty()) factors.push_back(Expression::reciprocal(Expression::product(divisors)));
    Expression product = Expression::product(std::move(factors));
    return coefficient.is_negative() ? Expression::negation(std::move(product)) : product;
}

Expression Writer::ordered_sum(const std::vector<Term>& terms, const numeric& denominator,
                               const std::vector<int>& divided_by) {
    std::vector<Expression> summands;
    for (const Term& summand : terms) {
        summands.push_back(term(summand, denominator, divided_by));
    }
    return Expression::sum(std::move(summands));
}

/// A sum does not begin with a minus sign where it need not: 1-cos(w), not -cos(w)+1.
Expression Writer::sum(const std::vector<Term>& terms, const numeric& denominator,
                       const std::vector<int>& divided_by) {
    std::vector<Term> ordered = terms;
    const auto is_positive = [](const Term& term) { return !is_negative(term); };
    const auto positive = std::find_if(ordered.begin(), ordered.end(), is_positive);
    if (positive != ordered.end()) std::rotate(ordered.begin(), positive, positive + 1);
    return ordered_sum(ordered, denominator, divided_by);
}

const Expression& shorter(const Expression& left, const Expression& right) {
    return to_text(right).size() < to_text(left).size() ? right : left;
}

Expression Writer::factored(const std::vector<Term>& terms) {
    Expression expanded = sum(terms, 1, {});
    if (terms.size() < 2) return expanded;
    Term common{0, terms.front().powers, {}};
    for (const Term& summand : terms) {
        common.coefficient = GiNaC::gcd(common.coefficient, summand.coefficient);
        for (std::size_t i = 0; i < common.powers.size(); ++i) {
            common.powers[i] = std::min(common.powers[i], summand.powers[i]);
        }
    }
    const bool has_powers = std::any_of(common.powers.begin(), common.powers.end(),
                                        [](int power) { return power != 0; });
    if (!has_powers && common.coefficient.is_equal(1)) return expanded;
    std::vector<Term> rest = terms;
    for (Term& summand : rest) {
        summand.coefficient /= common.coefficient;
        for (std::size_t i = 0; i < common.powers.size(); ++i) {
            summand.powers[i] -= common.powers[i];
        }
    }
    return shorter(expanded, Expression::product({term(common, 1, {}), sum(rest, 1, {})}));
}

/// NOTE: what is negative throughout has its sign in front. Else the signs above and below are
/// chosen so that the first term above is positive, unless that made a sum below begin with a minus
/// sign.
Expression Writer::quotient(const Fraction& fraction) {
    Fraction flipped = fraction;
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

/// The number of a parameter among the transcendental generators, or how many there are.
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
    const auto power = [&](const Term& term) {
        return index < term.powers.size() ? term.powers[index] : 0;
    };
    Fraction form = fraction(argument);
    Writer write(argument.field());
    const Term& divisor = form.denominator.front();
    if (form.denominator.size() == 1 && power(divisor) == 0) {
        std::stable_sort(form.numerator.begin(), form.numerator.end(),
                         [&](const Term& a, const Term& b) { return power(a) < power(b); });
        return write.ordered_sum(form.numerator, divisor.coefficient, divisor.powers);
    }
    const auto falls = [&](const Term& a, const Term& b) { return power(a) > power(b); };
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
    return fraction(argument).numerator.front().coefficient.is_negative() ? -1 : 1;
}

Expression closed_form(const Element& argument) {
    if (argument.is_zero()) return Expression::integer(0);
    const Field* const field = argument.field();
    const Fraction form = fraction(argument);
    Writer write(field);
    if (form.denominator.size() > 1) return write.quotient(form);
    const Term& divisor = form.denominator.front();
    const Expression termwise = write.sum(form.numerator, divisor.coefficient, divisor.powers);
    const bool divides = std::any_of(divisor.powers.begin(), divisor.powers.end(),
                                     [](int power) { return power != 0; });
    if (!divides) return termwise;
    return shorter(write.quotient(form), termwise);
}

}  // namespace hvi::gen
