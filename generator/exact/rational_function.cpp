// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/rational_function.hpp"

#include <flint/fmpq.h>
#include <flint/fmpz_mpoly_factor.h>
#include <flint/fmpz_vec.h>

#include <algorithm>
#include <array>

#include "generator/exact/integers.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

using GiNaC::numeric;
using Exponents = std::array<ulong, IntegerMultivariate::most_variables>;

const fmpz_mpoly_ctx_struct* context() { return IntegerMultivariate::context(); }

bool is_one(const IntegerMultivariate& a) { return fmpz_mpoly_is_one(a.get(), context()) != 0; }

IntegerMultivariate constant(const numeric& value) {
    IntegerMultivariate result;
    fmpz_mpoly_set_fmpz(result.get(), Integer(value).get(), context());
    return result;
}

IntegerMultivariate product(const IntegerMultivariate& a, const IntegerMultivariate& b) {
    if (is_one(a)) { return b; }
    if (is_one(b)) { return a; }
    IntegerMultivariate result;
    fmpz_mpoly_mul(result.get(), a.get(), b.get(), context());
    return result;
}

/// Divides both by their greatest common divisor, content included.
void cancel(IntegerMultivariate& a, IntegerMultivariate& b) {
    if (is_one(a) || is_one(b)) { return; }
    IntegerMultivariate divisor, rest_of_a, rest_of_b;
    const bool found = fmpz_mpoly_gcd_cofactors(divisor.get(), rest_of_a.get(), rest_of_b.get(),
                                                a.get(), b.get(), context()) != 0;
    HVI_CHECK(found);
    a = std::move(rest_of_a);
    b = std::move(rest_of_b);
}

numeric content_of(const IntegerMultivariate& a) {
    Integer result;
    _fmpz_vec_content(result.get(), a.get()->coeffs, a.get()->length);
    return result.value();
}

/// A rational of FLINT that is freed when it goes.
class Rational {
public:
    Rational() { fmpq_init(value_); }
    /// Precondition: both constant.
    Rational(const IntegerMultivariate& numerator, const IntegerMultivariate& denominator)
        : Rational() {
        fmpz_mpoly_get_fmpz(fmpq_numref(value_), numerator.get(), context());
        fmpz_mpoly_get_fmpz(fmpq_denref(value_), denominator.get(), context());
    }
    Rational(const Rational&) = delete;
    Rational& operator=(const Rational&) = delete;
    ~Rational() { fmpq_clear(value_); }
    [[nodiscard]] fmpq* get() { return value_; }

private:
    fmpq_t value_;
};

std::vector<RationalFunction::Term> terms_of(const IntegerMultivariate& a) {
    std::vector<RationalFunction::Term> result;
    for (slong i = 0; i < fmpz_mpoly_length(a.get(), context()); ++i) {
        Integer coefficient;
        Exponents powers;
        fmpz_mpoly_get_term_coeff_fmpz(coefficient.get(), a.get(), i, context());
        fmpz_mpoly_get_term_exp_ui(powers.data(), a.get(), i, context());
        result.push_back({coefficient.value(), {powers.begin(), powers.end()}});
    }
    return result;
}

std::optional<IntegerMultivariate> root_of(const IntegerMultivariate& square) {
    IntegerMultivariate root;
    if (fmpz_mpoly_sqrt(root.get(), square.get(), context()) == 0) { return std::nullopt; }
    return root;
}

}  // namespace

const fmpz_mpoly_ctx_struct* IntegerMultivariate::context() {
    struct Context {
        Context() { fmpz_mpoly_ctx_init(value, most_variables, ORD_LEX); }
        ~Context() { fmpz_mpoly_ctx_clear(value); }
        Context(const Context&) = delete;
        Context& operator=(const Context&) = delete;
        fmpz_mpoly_ctx_t value;
    };
    static const Context only;
    return only.value;
}

RationalFunction::RationalFunction(long value) {
    fmpz_mpoly_set_si(numerator_.get(), value, context());
    fmpz_mpoly_one(denominator_.get(), context());
}

RationalFunction::RationalFunction(const numeric& rational)
    : numerator_(constant(rational.numer())), denominator_(constant(rational.denom())) {}

RationalFunction RationalFunction::variable(std::size_t index) {
    HVI_CHECK(index < IntegerMultivariate::most_variables);
    RationalFunction result(1);
    fmpz_mpoly_gen(result.numerator_.get(), static_cast<slong>(index), context());
    return result;
}

RationalFunction RationalFunction::of(const Term& term) {
    Exponents powers{};
    std::copy(term.powers.begin(), term.powers.end(), powers.begin());
    RationalFunction result(term.coefficient);
    IntegerMultivariate monomial;
    fmpz_mpoly_set_coeff_ui_ui(monomial.get(), 1, powers.data(), context());
    result.numerator_ = product(result.numerator_, monomial);
    return result;
}

RationalFunction RationalFunction::of_rationals(const RationalFunction& a,
                                                const RationalFunction& b,
                                                RationalOperation operation) {
    Rational left(a.numerator_, a.denominator_);
    Rational right(b.numerator_, b.denominator_);
    operation(left.get(), left.get(), right.get());
    RationalFunction result;
    fmpz_mpoly_set_fmpz(result.numerator_.get(), fmpq_numref(left.get()), context());
    fmpz_mpoly_set_fmpz(result.denominator_.get(), fmpq_denref(left.get()), context());
    return result;
}

RationalFunction operator+(const RationalFunction& a, const RationalFunction& b) {
    if (a.is_rational() && b.is_rational()) {
        return RationalFunction::of_rationals(a, b, fmpq_add);
    }
    // a/(g r) + b/(g s) = (a s + b r)/(g r s), and only g has divisors in common with the sum.
    IntegerMultivariate r = a.denominator_;
    IntegerMultivariate s = b.denominator_;
    cancel(r, s);
    const IntegerMultivariate left = product(a.numerator_, s);
    const IntegerMultivariate right = product(b.numerator_, r);
    RationalFunction result;
    fmpz_mpoly_add(result.numerator_.get(), left.get(), right.get(), context());
    result.denominator_ = product(a.denominator_, s);
    if (result.is_zero()) { return 0; }
    cancel(result.numerator_, result.denominator_);
    return result;
}

RationalFunction operator*(const RationalFunction& a, const RationalFunction& b) {
    if (a.is_rational() && b.is_rational()) {
        return RationalFunction::of_rationals(a, b, fmpq_mul);
    }
    if (a.is_zero() || b.is_zero()) { return 0; }
    RationalFunction left = a;
    RationalFunction right = b;
    cancel(left.numerator_, right.denominator_);
    cancel(right.numerator_, left.denominator_);
    left.numerator_ = product(left.numerator_, right.numerator_);
    left.denominator_ = product(left.denominator_, right.denominator_);
    return left;
}

RationalFunction operator-(const RationalFunction& a) {
    RationalFunction result = a;
    fmpz_mpoly_neg(result.numerator_.get(), result.numerator_.get(), context());
    return result;
}

RationalFunction RationalFunction::inverse() const {
    HVI_CHECK(!is_zero());
    RationalFunction result;
    result.numerator_ = denominator_;
    result.denominator_ = numerator_;
    if (fmpz_sgn(result.denominator_.get()->coeffs) < 0) {
        fmpz_mpoly_neg(result.numerator_.get(), result.numerator_.get(), context());
        fmpz_mpoly_neg(result.denominator_.get(), result.denominator_.get(), context());
    }
    return result;
}

bool RationalFunction::is_zero() const {
    return fmpz_mpoly_is_zero(numerator_.get(), context()) != 0;
}

bool RationalFunction::is_rational() const {
    return fmpz_mpoly_is_fmpz(numerator_.get(), context()) != 0 &&
           fmpz_mpoly_is_fmpz(denominator_.get(), context()) != 0;
}

numeric RationalFunction::rational() const {
    HVI_CHECK(is_rational());
    Integer above, below;
    fmpz_mpoly_get_fmpz(above.get(), numerator_.get(), context());
    fmpz_mpoly_get_fmpz(below.get(), denominator_.get(), context());
    return above.value() / below.value();
}

bool RationalFunction::contains(std::size_t index) const {
    const auto variable = static_cast<slong>(index);
    return fmpz_mpoly_degree_si(numerator_.get(), variable, context()) > 0 ||
           fmpz_mpoly_degree_si(denominator_.get(), variable, context()) > 0;
}

std::vector<RationalFunction::Term> RationalFunction::numerator() const {
    return terms_of(numerator_);
}

std::vector<RationalFunction::Term> RationalFunction::denominator() const {
    return terms_of(denominator_);
}

std::size_t RationalFunction::term_count() const {
    return static_cast<std::size_t>(fmpz_mpoly_length(numerator_.get(), context()) +
                                    fmpz_mpoly_length(denominator_.get(), context()));
}

numeric RationalFunction::content() const {
    return content_of(numerator_) / content_of(denominator_);
}

std::optional<RationalFunction> RationalFunction::square_root() const {
    // In lowest terms a quotient is a square when both parts are.
    const auto above = root_of(numerator_);
    const auto below = root_of(denominator_);
    if (!above || !below) { return std::nullopt; }
    RationalFunction result;
    result.numerator_ = *above;
    result.denominator_ = *below;
    return result;
}

std::vector<RationalFunction::Factor> RationalFunction::factors() const {
    struct Factors {
        Factors() { fmpz_mpoly_factor_init(value, context()); }
        ~Factors() { fmpz_mpoly_factor_clear(value, context()); }
        Factors(const Factors&) = delete;
        Factors& operator=(const Factors&) = delete;
        fmpz_mpoly_factor_t value;
    } found;
    const bool done = fmpz_mpoly_factor(found.value, numerator_.get(), context()) != 0;
    HVI_CHECK(done);
    fmpz_mpoly_factor_sort(found.value, context());
    std::vector<Factor> result;
    for (slong i = 0; i < fmpz_mpoly_factor_length(found.value, context()); ++i) {
        Factor& factor = result.emplace_back();
        fmpz_mpoly_factor_get_base(factor.base.numerator_.get(), found.value, i, context());
        fmpz_mpoly_one(factor.base.denominator_.get(), context());
        const slong exponent = fmpz_mpoly_factor_get_exp_si(found.value, i, context());
        factor.exponent = static_cast<unsigned>(exponent);
    }
    return result;
}

unsigned RationalFunction::degree(std::size_t index) const {
    const slong degree =
        fmpz_mpoly_degree_si(numerator_.get(), static_cast<slong>(index), context());
    return static_cast<unsigned>(std::max<slong>(degree, 0));
}

RationalFunction common_denominator(const RationalFunction& a, const RationalFunction& b) {
    IntegerMultivariate r = a.denominator_;
    IntegerMultivariate s = b.denominator_;
    cancel(r, s);
    RationalFunction result(1);
    result.numerator_ = product(a.denominator_, s);
    return result;
}

}  // namespace hvi::gen
