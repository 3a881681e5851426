// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/hamiltonian/normal_form.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "generator/support/work.hpp"

namespace hvi::gen {

namespace {

using GiNaC::ex;

/// Upper bounds of the terms of a fraction: in the numerator, and in each base of the denominator.
struct FractionTerms {
    double above = 1;
    std::map<ex, double, GiNaC::ex_is_less> below = {};
};

double terms_of_sum(const ex& base) {
    return GiNaC::is_a<GiNaC::add>(base) ? static_cast<double>(base.nops()) : 1;
}

double terms_below(const FractionTerms& fraction) {
    double product = 1;
    for (const auto& [base, exponent] : fraction.below)
        product *= std::pow(terms_of_sum(base), exponent);
    return product;
}

FractionTerms fraction_terms(const ex& expression);

/// Bounds the terms of a sum over one denominator.
FractionTerms terms_of_sum_of_fractions(const ex& sum) {
    FractionTerms result;
    double above = 0;
    std::vector<FractionTerms> parts;
    for (const ex& part : sum) {
        parts.push_back(fraction_terms(part));
        for (const auto& [base, exponent] : parts.back().below) {
            double& most = result.below[base];
            most = std::max(most, exponent);
        }
    }
    const double below = terms_below(result);
    for (const FractionTerms& part : parts) above += part.above * below / terms_below(part);
    result.above = above;
    return result;
}

FractionTerms fraction_terms(const ex& expression) {
    if (GiNaC::is_a<GiNaC::add>(expression)) return terms_of_sum_of_fractions(expression);
    FractionTerms result;
    if (GiNaC::is_a<GiNaC::mul>(expression)) {
        for (const ex& factor : expression) {
            const FractionTerms part = fraction_terms(factor);
            result.above *= part.above;
            for (const auto& [base, exponent] : part.below) result.below[base] += exponent;
        }
        return result;
    }
    const bool is_power =
        GiNaC::is_a<GiNaC::power>(expression) && expression.op(1).info(GiNaC::info_flags::integer);
    if (!is_power) return result;
    const double exponent = GiNaC::ex_to<GiNaC::numeric>(expression.op(1)).to_double();
    if (exponent < 0)
        result.below[expression.op(0)] = -exponent;
    else
        result.above = std::pow(fraction_terms(expression.op(0)).above, exponent);
    return result;
}

}  // namespace

void spend_on_normal_form(const ex& expression) {
    constexpr double units_of_term = 5;  // as measured
    const FractionTerms terms = fraction_terms(expression);
    spend_work(units_of_term * (terms.above + terms_below(terms)));
}

ex normal_form(const ex& expression) {
    spend_on_normal_form(expression);
    return expression.normal();
}

ex common_divisor(const ex& a, const ex& b) {
    constexpr double units_of_pair = 5;
    spend_work(units_of_pair * terms_of_sum(a) * terms_of_sum(b));
    return GiNaC::gcd(a, b);
}

ex multiplied_out(const ex& expression) {
    constexpr double most_expanded = 20'000;
    const double terms = fraction_terms(expression).above;
    if (terms > most_expanded) return expression;
    spend_work(terms);
    return expression.expand();
}

}  // namespace hvi::gen
