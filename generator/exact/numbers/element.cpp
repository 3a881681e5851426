// Arithmetic of field elements in their normal form.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include "generator/exact/numbers/field.hpp"
#include "generator/exact/numbers/minors.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

Field* common_field(const Element& left, const Element& right) {
    HVI_CHECK(left.field() == nullptr || right.field() == nullptr || left.field() == right.field());
    return left.field() != nullptr ? left.field() : right.field();
}

unsigned exponent(const Monomial& monomial, std::size_t index) {
    return index < monomial.size() ? monomial[index] : 0;
}

Monomial with_exponent(Monomial monomial, std::size_t index, unsigned value) {
    if (index >= monomial.size()) monomial.resize(index + 1);
    monomial[index] = value;
    while (!monomial.empty() && monomial.back() == 0) monomial.pop_back();
    return monomial;
}

Monomial product(const Monomial& left, const Monomial& right) {
    Monomial result(std::max(left.size(), right.size()));
    for (std::size_t i = 0; i < result.size(); ++i) {
        result[i] = exponent(left, i) + exponent(right, i);
    }
    return result;
}

using Terms = Element::Terms;

void add(Terms& terms, const Monomial& monomial, const IntegerMultivariate& coefficient) {
    IntegerMultivariate& sum = terms[monomial];
    sum += coefficient;
    if (sum.is_zero()) { terms.erase(monomial); }
}

/// Arithmetic of polynomials within the budget of a field. Without a field there are rationals
/// alone, which are free.
class Frugal {
public:
    explicit Frugal(Field* field) : budget_(field != nullptr ? &field->budget() : nullptr) {}

    [[nodiscard]] IntegerMultivariate product(const IntegerMultivariate& a,
                                              const IntegerMultivariate& b) const {
        if (a.is_one()) { return b; }
        if (b.is_one()) { return a; }
        if (budget_ != nullptr) { budget_->spend_on_product(a, b); }
        IntegerMultivariate result = a * b;
        Budget::check_length(result);
        return result;
    }
    void divide(IntegerMultivariate& dividend, const IntegerMultivariate& divisor) const {
        if (divisor.is_one()) { return; }
        dividend /= divisor;
        if (budget_ != nullptr) { budget_->spend_on_product(dividend, divisor); }
    }
    [[nodiscard]] IntegerMultivariate gcd(const IntegerMultivariate& a,
                                          const IntegerMultivariate& b) const {
        const bool is_known = a.is_one() || b.is_one();
        if (!is_known && budget_ != nullptr) { budget_->spend_on_divisor(a, b); }
        return hvi::gen::gcd(a, b);
    }

private:
    Budget* budget_;
};

void multiply(Terms& terms, const IntegerMultivariate& factor, const Frugal& frugal) {
    if (factor.is_one()) { return; }
    for (auto& [monomial, coefficient] : terms) {
        coefficient = frugal.product(coefficient, factor);
    }
}

Terms product(const Terms& left, const Terms& right, const Frugal& frugal) {
    Terms result;
    for (const auto& [left_monomial, left_coefficient] : left) {
        for (const auto& [right_monomial, right_coefficient] : right) {
            add(result, product(left_monomial, right_monomial),
                frugal.product(left_coefficient, right_coefficient));
        }
    }
    return result;
}

/// Returns the greatest common divisor of all coefficients and `other`. The shortest come first:
/// the divisor is often 1 after the first of them, and the rest is skipped.
IntegerMultivariate common_divisor(const Terms& terms, const IntegerMultivariate& other,
                                   const Frugal& frugal) {
    std::vector<const IntegerMultivariate*> coefficients;
    for (const auto& [monomial, coefficient] : terms) { coefficients.push_back(&coefficient); }
    std::sort(coefficients.begin(), coefficients.end(), [](const auto* left, const auto* right) {
        return left->term_count() < right->term_count();
    });
    IntegerMultivariate divisor = other;
    for (const IntegerMultivariate* const coefficient : coefficients) {
        if (divisor.is_one()) { break; }
        divisor = frugal.gcd(divisor, *coefficient);
    }
    return divisor;
}

/// Divides all by their common divisor.
void cancel(Terms& numerator, IntegerMultivariate& denominator, const Frugal& frugal) {
    const IntegerMultivariate divisor = common_divisor(numerator, denominator, frugal);
    for (auto& [monomial, coefficient] : numerator) { frugal.divide(coefficient, divisor); }
    frugal.divide(denominator, divisor);
}

/// Takes out the terms with the highest power of generator `index` that its relation applies to.
std::optional<Terms> take_reducible(Terms& terms, std::size_t index, unsigned degree) {
    unsigned highest = 0;
    for (const auto& [monomial, coefficient] : terms) {
        highest = std::max(highest, exponent(monomial, index));
    }
    if (highest < degree) { return std::nullopt; }
    Terms taken;
    for (auto term = terms.begin(); term != terms.end();) {
        const auto next = std::next(term);
        if (exponent(term->first, index) == highest) {
            taken.emplace(with_exponent(term->first, index, highest - degree),
                          std::move(term->second));
            terms.erase(term);
        }
        term = next;
    }
    return taken;
}

/// Applies the relations until none applies. The result has to be divided by the returned divisor,
/// which is empty where no relation applied.
std::optional<IntegerMultivariate> reduce(Terms& terms, Field* field) {
    const Frugal frugal(field);
    std::size_t level = 0;
    for (const auto& [monomial, coefficient] : terms) { level = std::max(level, monomial.size()); }
    std::optional<IntegerMultivariate> denominator;
    for (std::size_t i = level; i-- > 0;) {
        const Algebraic& generator = field->algebraic(i);
        while (const auto high = take_reducible(terms, i, generator.degree)) {
            const IntegerMultivariate& divisor = generator.reduced.denominator();
            multiply(terms, divisor, frugal);
            denominator = denominator ? frugal.product(*denominator, divisor) : divisor;
            for (const auto& [monomial, coefficient] :
                 product(*high, generator.reduced.numerator(), frugal)) {
                add(terms, monomial, coefficient);
            }
        }
    }
    return denominator;
}

using RationalOperation = void (*)(fmpq_t, const fmpq_t, const fmpq_t);

/// Returns the result of a rational operation. NOTE: FLINT's rationals are much faster.
/// Precondition: both are rational.
Element of_rationals(const Element& left, const Element& right, RationalOperation operation) {
    Rational result = left.rational();
    operation(result.get(), result.get(), right.rational().get());
    return Element(result, common_field(left, right));
}

}  // namespace

Element::Element(const Rational& rational, Field* field)
    : Element(copy_of(rational.get(), field)) {}

Element Element::copy_of(const fmpq* rational, Field* field) {
    Element result;
    result.field_ = field;
    if (fmpz_is_zero(fmpq_numref(rational)) != 0) { return result; }
    const auto* const context = IntegerMultivariate::context();
    fmpz_mpoly_set_fmpz(result.numerator_[{}].get(), fmpq_numref(rational), context);
    fmpz_mpoly_set_fmpz(result.denominator_.get(), fmpq_denref(rational), context);
    return result;
}

Element Element::variable(std::size_t index, Field* field) {
    return quotient({{{}, IntegerMultivariate::variable(index)}}, IntegerMultivariate(1), field);
}

Element Element::product(const Monomial& monomial, Field* field) {
    Terms terms{{monomial, IntegerMultivariate(1)}};
    auto denominator = reduce(terms, field);
    if (!denominator) { denominator.emplace(1); }
    return quotient(std::move(terms), *std::move(denominator), field);
}

Element Element::quotient(Terms numerator, IntegerMultivariate denominator, Field* field) {
    Element result;
    result.field_ = field;
    if (numerator.empty()) { return result; }
    cancel(numerator, denominator, Frugal(field));
    if (denominator.leading_sign() < 0) {
        for (auto& [monomial, coefficient] : numerator) { coefficient.negate(); }
        denominator.negate();
    }
    result.numerator_ = std::move(numerator);
    result.denominator_ = std::move(denominator);
    return result;
}

bool Element::is_rational() const {
    return is_zero() || (numerator_.size() == 1 && numerator_.begin()->first.empty() &&
                         numerator_.begin()->second.is_constant() && denominator_.is_constant());
}

bool Element::is_integer(long value) const {
    if (is_zero() || value == 0) { return is_zero() && value == 0; }
    return is_rational() && denominator_.is_one() &&
           fmpz_mpoly_equal_si(numerator_.begin()->second.get(), value,
                               IntegerMultivariate::context()) != 0;
}

Rational Element::rational() const {
    Rational result;
    copy_to(result.get());
    return result;
}

void Element::copy_to(fmpq* rational) const {
    HVI_CHECK(is_rational());
    if (is_zero()) {
        fmpq_zero(rational);
        return;
    }
    const auto* const context = IntegerMultivariate::context();
    fmpz_mpoly_get_fmpz(fmpq_numref(rational), numerator_.begin()->second.get(), context);
    fmpz_mpoly_get_fmpz(fmpq_denref(rational), denominator_.get(), context);
}

Element operator+(const Element& left, const Element& right) {
    if (left.is_rational() && right.is_rational()) { return of_rationals(left, right, fmpq_add); }
    // a/(g r) + b/(g s) = (a s + b r)/(g r s), and only g has divisors in common with the sum.
    Element result;
    result.field_ = common_field(left, right);
    const Frugal frugal(result.field_);
    IntegerMultivariate g = frugal.gcd(left.denominator_, right.denominator_);
    IntegerMultivariate r = left.denominator_;
    IntegerMultivariate s = right.denominator_;
    frugal.divide(r, g);
    frugal.divide(s, g);
    result.numerator_ = left.numerator_;
    multiply(result.numerator_, s, frugal);
    for (const auto& [monomial, coefficient] : right.numerator_) {
        add(result.numerator_, monomial, frugal.product(coefficient, r));
    }
    if (result.is_zero()) { return result; }
    cancel(result.numerator_, g, frugal);
    result.denominator_ = frugal.product(frugal.product(g, r), s);
    return result;
}

Element operator-(const Element& argument) {
    Element result = argument;
    for (auto& [monomial, coefficient] : result.numerator_) { coefficient.negate(); }
    return result;
}

Element operator-(const Element& left, const Element& right) { return left + -right; }

Element operator*(const Element& left, const Element& right) {
    if (left.is_rational() && right.is_rational()) { return of_rationals(left, right, fmpq_mul); }
    Element result;
    result.field_ = common_field(left, right);
    if (left.is_zero() || right.is_zero()) { return result; }
    const Frugal frugal(result.field_);
    Element a = left;
    Element b = right;
    cancel(a.numerator_, b.denominator_, frugal);
    cancel(b.numerator_, a.denominator_, frugal);
    result.numerator_ = product(a.numerator_, b.numerator_, frugal);
    // NOTE: by Gauss's lemma there is nothing more to cancel, unless a relation was applied.
    auto divisor = reduce(result.numerator_, result.field_);
    if (result.is_zero()) { return result; }
    if (divisor) {
        for (auto* const denominator : {&a.denominator_, &b.denominator_, &*divisor}) {
            cancel(result.numerator_, *denominator, frugal);
        }
        a.denominator_ = frugal.product(a.denominator_, *divisor);
    }
    result.denominator_ = frugal.product(a.denominator_, b.denominator_);
    return result;
}

Element power(const Element& base, unsigned exponent) {
    Element result(1);
    Element square = base;
    for (; exponent != 0; exponent /= 2) {
        if (exponent % 2 == 1) result = result * square;
        if (exponent > 1) square = square * square;
    }
    return result;
}

std::size_t Element::term_count() const {
    std::size_t count = denominator_.term_count();
    for (const auto& [monomial, coefficient] : numerator_) { count += coefficient.term_count(); }
    return count;
}

std::size_t Element::level() const {
    std::size_t result = 0;
    for (const auto& [monomial, coefficient] : numerator_) {
        result = std::max(result, monomial.size());
    }
    return result;
}

std::vector<Element> Element::coefficients(std::size_t index) const {
    std::vector<Terms> parts(field_ == nullptr ? 1 : field_->algebraic(index).degree);
    for (const auto& [monomial, coefficient] : numerator_) {
        parts.at(exponent(monomial, index)).emplace(with_exponent(monomial, index, 0), coefficient);
    }
    std::vector<Element> result;
    for (Terms& part : parts) { result.push_back(quotient(std::move(part), denominator_, field_)); }
    return result;
}

namespace {

/// Returns g^index, where g is the algebraic generator below `level`.
Element generator_power(Field* field, std::size_t level, std::size_t index) {
    return Element::product(with_exponent({}, level - 1, static_cast<unsigned>(index)), field);
}

/// A number without its denominator and the divisor of its coefficients.
struct Primitive {
    Element part;
    Element inverse_factor;  ///< the inverse of the factor that was left out
};

Primitive primitive(const Element& argument) {
    Terms terms = argument.numerator();
    Field* const field = argument.field();
    const Frugal frugal(field);
    IntegerMultivariate divisor = common_divisor(terms, {}, frugal);
    for (auto& [monomial, coefficient] : terms) { frugal.divide(coefficient, divisor); }
    return {Element::quotient(std::move(terms), IntegerMultivariate(1), field),
            Element::quotient({{{}, argument.denominator()}}, std::move(divisor), field)};
}

}  // namespace

Element inverse(const Element& argument) {
    HVI_CHECK(!argument.is_zero());
    const auto [part, inverse_factor] = primitive(argument);
    const std::size_t level = part.level();
    Field* const field = argument.field();
    if (level == 0) { return part * inverse_factor; }  // the part is 1 or -1
    // Multiplication by the part is a matrix over the field below its last generator g; the inverse
    // solves that matrix times it = 1. NOTE: with a single division at the end: Euclid's algorithm
    // divides at each step, and its coefficients swell.
    const unsigned degree = field->algebraic(level - 1).degree;
    SquareMatrix<Element> multiplication(degree, std::vector<Element>(degree));
    for (unsigned k = 0; k < degree; ++k) {
        const auto column = (part * generator_power(field, level, k)).coefficients(level - 1);
        for (unsigned i = 0; i < degree; ++i) multiplication[i][k] = column[i];
    }
    const auto [adjugate, norm] = by_minors(multiplication);
    if (norm.is_zero()) {
        throw MathError("cannot decide whether a number is zero", {},
                        "it is a divisor of zero in the algebraic normal form");
    }
    Element result;
    for (unsigned k = 0; k < degree; ++k) {
        result = result + adjugate[k][0] * generator_power(field, level, k);
    }
    return result * (inverse_factor * inverse(norm));
}

bool has_parameters(const Element& argument) {
    if (argument.field() == nullptr) { return false; }
    const auto& generators = argument.field()->transcendentals();
    const auto has = [&](const IntegerMultivariate& polynomial) {
        for (std::size_t i = 0; i < generators.size(); ++i) {
            if (generators[i].is_parameter && polynomial.contains(i)) { return true; }
        }
        return false;
    };
    if (has(argument.denominator())) { return true; }
    for (const auto& [monomial, coefficient] : argument.numerator()) {
        for (std::size_t i = 0; i < monomial.size(); ++i) {
            if (monomial[i] != 0 && argument.field()->algebraic(i).is_parameter) { return true; }
        }
        if (has(coefficient)) { return true; }
    }
    return false;
}

}  // namespace hvi::gen
