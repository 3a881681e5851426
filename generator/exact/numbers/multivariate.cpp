// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/numbers/multivariate.hpp"

#include <flint/fmpz_mpoly_factor.h>
#include <flint/fmpz_vec.h>

#include <algorithm>
#include <array>

#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

using Exponents = std::array<ulong, IntegerMultivariate::most_variables>;

const fmpz_mpoly_ctx_struct* context() { return IntegerMultivariate::context(); }

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

IntegerMultivariate IntegerMultivariate::variable(std::size_t index) {
    HVI_CHECK(index < most_variables);
    IntegerMultivariate result;
    fmpz_mpoly_gen(result.get(), static_cast<slong>(index), context());
    return result;
}

IntegerMultivariate IntegerMultivariate::of(const Term& term) {
    Exponents powers{};
    std::copy(term.powers.begin(), term.powers.end(), powers.begin());
    IntegerMultivariate result;
    fmpz_mpoly_set_coeff_fmpz_ui(result.get(), term.coefficient.get(), powers.data(), context());
    return result;
}

std::vector<IntegerMultivariate::Term> IntegerMultivariate::terms() const {
    std::vector<Term> result;
    for (slong i = 0; i < fmpz_mpoly_length(get(), context()); ++i) {
        Term term;
        Exponents powers;
        fmpz_mpoly_get_term_coeff_fmpz(term.coefficient.get(), get(), i, context());
        fmpz_mpoly_get_term_exp_ui(powers.data(), get(), i, context());
        term.powers.assign(powers.begin(), powers.end());
        result.push_back(std::move(term));
    }
    return result;
}

std::size_t IntegerMultivariate::term_count() const {
    return static_cast<std::size_t>(fmpz_mpoly_length(get(), context()));
}

IntegerMultivariate operator*(const IntegerMultivariate& a, const IntegerMultivariate& b) {
    if (a.is_one()) { return b; }
    if (b.is_one()) { return a; }
    IntegerMultivariate result;
    fmpz_mpoly_mul(result.get(), a.get(), b.get(), context());
    return result;
}

IntegerMultivariate& IntegerMultivariate::operator+=(const IntegerMultivariate& other) {
    fmpz_mpoly_add(get(), get(), other.get(), context());
    return *this;
}

IntegerMultivariate& IntegerMultivariate::operator/=(const IntegerMultivariate& divisor) {
    if (divisor.is_one()) { return *this; }
    const bool divides = fmpz_mpoly_divides(get(), get(), divisor.get(), context()) != 0;
    HVI_CHECK(divides);
    return *this;
}

void IntegerMultivariate::negate() { fmpz_mpoly_neg(get(), get(), context()); }

bool IntegerMultivariate::is_zero() const { return fmpz_mpoly_is_zero(get(), context()) != 0; }

bool IntegerMultivariate::is_one() const { return fmpz_mpoly_is_one(get(), context()) != 0; }

bool IntegerMultivariate::is_constant() const { return fmpz_mpoly_is_fmpz(get(), context()) != 0; }

Integer IntegerMultivariate::constant() const {
    Integer result;
    fmpz_mpoly_get_fmpz(result.get(), get(), context());
    return result;
}

bool IntegerMultivariate::contains(std::size_t index) const {
    return fmpz_mpoly_degree_si(get(), static_cast<slong>(index), context()) > 0;
}

int IntegerMultivariate::leading_sign() const { return is_zero() ? 0 : fmpz_sgn(get()->coeffs); }

Integer IntegerMultivariate::content() const {
    Integer result;
    _fmpz_vec_content(result.get(), get()->coeffs, get()->length);
    return result;
}

unsigned IntegerMultivariate::degree(std::size_t index) const {
    const slong degree = fmpz_mpoly_degree_si(get(), static_cast<slong>(index), context());
    return static_cast<unsigned>(std::max<slong>(degree, 0));
}

std::optional<IntegerMultivariate>
IntegerMultivariate::divided_by(const IntegerMultivariate& divisor) const {
    IntegerMultivariate quotient;
    if (fmpz_mpoly_divides(quotient.get(), get(), divisor.get(), context()) == 0) {
        return std::nullopt;
    }
    return quotient;
}

std::vector<IntegerMultivariate::Factor> IntegerMultivariate::factors() const {
    struct Factors {
        Factors() { fmpz_mpoly_factor_init(value, context()); }
        ~Factors() { fmpz_mpoly_factor_clear(value, context()); }
        Factors(const Factors&) = delete;
        Factors& operator=(const Factors&) = delete;
        fmpz_mpoly_factor_t value;
    } found;
    const bool done = fmpz_mpoly_factor(found.value, get(), context()) != 0;
    HVI_CHECK(done);
    fmpz_mpoly_factor_sort(found.value, context());
    std::vector<Factor> result;
    for (slong i = 0; i < fmpz_mpoly_factor_length(found.value, context()); ++i) {
        Factor& factor = result.emplace_back();
        fmpz_mpoly_factor_get_base(factor.base.get(), found.value, i, context());
        if (factor.base.leading_sign() < 0) { factor.base.negate(); }
        const slong exponent = fmpz_mpoly_factor_get_exp_si(found.value, i, context());
        factor.exponent = static_cast<unsigned>(exponent);
    }
    return result;
}

std::optional<IntegerMultivariate> IntegerMultivariate::square_root() const {
    IntegerMultivariate root;
    if (fmpz_mpoly_sqrt(root.get(), get(), context()) == 0) { return std::nullopt; }
    return root;
}

IntegerMultivariate gcd(const IntegerMultivariate& a, const IntegerMultivariate& b) {
    if (a.is_one()) { return a; }
    if (b.is_one()) { return b; }
    IntegerMultivariate result = a;
    if (fmpz_mpoly_equal(a.get(), b.get(), context()) != 0) {
        if (a.leading_sign() < 0) { result.negate(); }
        return result;
    }
    const bool found = fmpz_mpoly_gcd(result.get(), a.get(), b.get(), context()) != 0;
    HVI_CHECK(found);
    return result;
}

IntegerMultivariate power(const IntegerMultivariate& base, unsigned exponent) {
    IntegerMultivariate result(1);
    for (; exponent > 0; --exponent) { result = result * base; }
    return result;
}

}  // namespace hvi::gen
