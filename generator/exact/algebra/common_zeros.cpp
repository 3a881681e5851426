// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/algebra/common_zeros.hpp"

#include "generator/exact/algebra/polynomial.hpp"
#include "generator/exact/numbers/number_value.hpp"

namespace hvi::gen {

namespace {

/// Returns the variable that occurs; empty where there are several.
std::optional<std::size_t> single_variable(const std::vector<IntegerMultivariate>& polynomials) {
    std::optional<std::size_t> variable;
    for (const IntegerMultivariate& polynomial : polynomials) {
        for (std::size_t i = 0; i < IntegerMultivariate::most_variables; ++i) {
            if (!polynomial.contains(i)) { continue; }
            if (variable && *variable != i) { return {}; }
            variable = i;
        }
    }
    return variable;
}

/// Returns the numerator, where nothing but transcendental generators occurs.
std::optional<IntegerMultivariate> numerator(const Number& number) {
    const Element* const element = number.value().element();
    if (element == nullptr || element->level() > 0) { return {}; }
    if (element->is_zero()) { return IntegerMultivariate(); }
    return element->numerator().begin()->second;
}

RationalPolynomial univariate(const IntegerMultivariate& polynomial, std::size_t variable) {
    RationalPolynomial result;
    for (const IntegerMultivariate::Term& term : polynomial.terms()) {
        const unsigned power = variable < term.powers.size() ? term.powers[variable] : 0;
        fmpq_poly_set_coeff_fmpz(result.get(), power, term.coefficient.get());
    }
    return result;
}

}  // namespace

std::optional<CommonZeros> common_zeros(const std::vector<Number>& functions) {
    std::vector<IntegerMultivariate> numerators;
    IntegerMultivariate divisor;
    std::shared_ptr<Field> field;
    for (const Number& function : functions) {
        auto next = numerator(function);
        if (!next) { return {}; }
        divisor = gcd(divisor, *next);
        numerators.push_back(*std::move(next));
        if (function.value().field) { field = function.value().field; }
    }
    const auto variable = single_variable(numerators);
    if (!variable) { return {}; }
    const Transcendental& generator = field->transcendentals()[*variable];
    if (!generator.is_parameter || generator.form.kind != Expression::Kind::symbol) { return {}; }
    return CommonZeros{generator.form.name,
                       real_roots(univariate(divisor, *variable), Ground(field))};
}

}  // namespace hvi::gen
