// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/algebra/polynomial_quotient.hpp"

#include <utility>

#include "generator/exact/algebra/polynomial_arithmetic.hpp"
#include "generator/exact/numbers/number_value.hpp"

namespace hvi::gen {

namespace {

/// Returns the polynomial with its highest power first. Empty where a coefficient has no closed
/// form.
std::optional<Expression> closed_form(const NumberPolynomial& polynomial) {
    std::vector<Expression> terms;
    for (std::size_t k = polynomial.size(); k-- > 0;) {
        if (is_exactly(polynomial[k], 0)) { continue; }
        const auto coefficient = polynomial[k].closed_form();
        if (!coefficient) { return std::nullopt; }
        const bool negative = coefficient->kind == Expression::Kind::negation;
        const Expression& size = negative ? coefficient->arguments.front() : *coefficient;
        std::vector<Expression> factors;
        if (k == 0 || to_text(size) != "1") { factors.push_back(size); }
        if (k > 0) {
            const Expression z = Expression::symbol("z");
            factors.push_back(
                k == 1 ? z : Expression::power(z, Expression::integer(static_cast<long>(k))));
        }
        Expression term = Expression::product(std::move(factors));
        terms.push_back(negative ? Expression::negation(std::move(term)) : std::move(term));
    }
    return Expression::sum(std::move(terms));
}

/// NOTE: one coefficient is 1, and so the integers have no common divisor.
PolynomialQuotient with_integers(const RationalPolynomial& numerator,
                                 const RationalPolynomial& denominator) {
    Integer multiple;
    fmpz_lcm(multiple.get(), fmpq_poly_denref(numerator.get()),
             fmpq_poly_denref(denominator.get()));
    RationalPolynomial above, below;
    fmpq_poly_scalar_mul_fmpz(above.get(), numerator.get(), multiple.get());
    fmpq_poly_scalar_mul_fmpz(below.get(), denominator.get(), multiple.get());
    return {numbers(above), numbers(below)};
}

}  // namespace

std::optional<Expression> closed_form(const PolynomialQuotient& quotient) {
    const auto above = over_rationals(quotient.numerator);
    const auto below = over_rationals(quotient.denominator);
    const PolynomialQuotient written = above && below ? with_integers(*above, *below) : quotient;
    auto numerator = closed_form(written.numerator);
    auto denominator = closed_form(written.denominator);
    if (!numerator || !denominator) { return std::nullopt; }
    if (to_text(*denominator) == "1") { return numerator; }
    return Expression::product(
        {*std::move(numerator), Expression::reciprocal(*std::move(denominator))});
}

std::optional<double> value_at(const PolynomialQuotient& quotient, double z) {
    constexpr slong enough_bits = 40;  // bits behind the binary point
    Ball argument;
    arb_set_d(argument.get(), z);
    for (Precision bits = first_precision; bits <= last_precision; bits *= 2) {
        Ball value = enclosure(quotient.numerator, argument, bits);
        const Ball denominator = enclosure(quotient.denominator, argument, bits);
        arb_div(value.get(), value.get(), denominator.get(), bits);
        mag_t radius;
        mag_init_set(radius, arb_radref(value.get()));
        const bool is_good = mag_cmp_2exp_si(radius, -enough_bits) < 0;
        mag_clear(radius);
        if (is_good) { return arf_get_d(arb_midref(value.get()), ARF_RND_NEAR); }
    }
    return std::nullopt;
}

}  // namespace hvi::gen
