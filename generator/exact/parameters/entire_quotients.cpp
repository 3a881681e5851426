// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/parameters/entire_quotients.hpp"

#include <algorithm>
#include <utility>

#include "generator/exact/numbers/number_value.hpp"
#include "generator/exact/parameters/tangents.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

bool same(const EntireFunction& left, const EntireFunction& right) {
    return std::equal(left.terms.begin(), left.terms.end(), right.terms.begin(), right.terms.end(),
                      [](const auto& a, const auto& b) {
                          return a.powers == b.powers && (a.coefficient - b.coefficient).is_zero();
                      });
}

/// Returns the place of a function among the known ones; a new one is added at the end.
std::size_t place_of(std::vector<EntireFunction>& known, const EntireFunction& function) {
    const auto found = std::find_if(known.begin(), known.end(),
                                    [&](const auto& other) { return same(other, function); });
    if (found != known.end()) { return static_cast<std::size_t>(found - known.begin()); }
    known.push_back(function);
    return known.size() - 1;
}

}  // namespace

// ---- quotients ----

Quotient EntireQuotients::add(const Number& number) {
    const Element quotient = in_tangents(*number.value().element(), generators_.angles());
    Element::Terms above = quotient.numerator();
    Quotient result;
    Surplus surplus = divide_by(quotient.denominator(), result);
    for (std::size_t p = 0; p < phase_count(); ++p) {
        const std::size_t t = variable(p);
        unsigned degree = 0;
        if (generators_.is_angle(t)) { degree = 2 * without_secants(above, t); }
        surplus[p] -= static_cast<int>(degree + degree_of(above, p));
    }
    EntireFunction numerator = homogeneous(above);
    balance(numerator, surplus, result);
    result.numerator = place_of(numerators_, numerator);
    return result;
}

/// Makes the factors of a denominator those of the quotient. NOTE: 1 + t^2 = 1/y^2 is no function
/// of its own.
EntireQuotients::Surplus EntireQuotients::divide_by(const IntegerMultivariate& denominator,
                                                    Quotient& quotient) {
    Surplus surplus(phase_count());
    IntegerMultivariate rest = denominator;
    for (const auto& [base, exponent] : denominator.factors()) {
        rest /= power(base, exponent);
        for (std::size_t p = 0; p < phase_count(); ++p) {
            surplus[p] += static_cast<int>(exponent * base.degree(variable(p)));
        }
        if (!is_secant(base)) { factor(quotient, homogeneous({{Monomial{}, base}}), exponent); }
    }
    HVI_CHECK(rest.is_constant());
    quotient.divisor = generators_.exact(Element(rest.constant()));
    return surplus;
}

/// Multiplies by powers of y, so that numerator and denominator have one degree.
void EntireQuotients::balance(EntireFunction& numerator, const Surplus& surplus,
                              Quotient& quotient) {
    for (std::size_t p = 0; p < phase_count(); ++p) {
        const std::size_t y = EntireGenerators::y(p);
        if (surplus[p] < 0) { factor(quotient, generator(y), static_cast<unsigned>(-surplus[p])); }
        for (EntireFunction::Term& term : numerator.terms) {
            term.powers[y] += static_cast<unsigned>(std::max(surplus[p], 0));
        }
    }
}

void EntireQuotients::factor(Quotient& quotient, const EntireFunction& function,
                             unsigned exponent) {
    const std::size_t place = place_of(factors_, function);
    if (quotient.exponents.size() <= place) { quotient.exponents.resize(place + 1); }
    quotient.exponents[place] += exponent;
}

ParametricNumbers EntireQuotients::finish(std::vector<Quotient> weights,
                                          std::vector<Quotient> others) && {
    ParametricNumbers result;
    result.parameter = generators_.parameter();
    result.generators = generators_.entire();
    for (EntireFunction& function : factors_) {
        const Zero zero = has_zeros(function) ? Zero::pole : Zero::harmless;
        result.functions.push_back({std::move(function), zero, 0});
    }
    for (EntireFunction& function : numerators_) {
        result.functions.push_back({std::move(function), Zero::harmless, 0});
    }
    for (auto* quotients : {&weights, &others}) {
        for (Quotient& quotient : *quotients) {
            quotient.numerator += factors_.size();
            quotient.exponents.resize(factors_.size());
            ParameterFunction& above = result.functions[quotient.numerator];
            const bool is_weight = quotients == &weights && has_zeros(above.function);
            if (is_weight) { above.zero = Zero::weight; }
        }
    }
    result.weights = std::move(weights);
    result.others = std::move(others);
    return result;
}

// ---- functions ----

bool EntireQuotients::is_secant(const IntegerMultivariate& base) const {
    const std::vector<std::size_t> angles = generators_.angles();
    return std::any_of(angles.begin(), angles.end(), [&](std::size_t t) {
        return base.divided_by(secant_squared(t)).has_value();
    });
}

unsigned EntireQuotients::degree_of(const Element::Terms& polynomials, std::size_t phase) const {
    unsigned degree = 0;
    for (const auto& [constants, polynomial] : polynomials) {
        degree = std::max(degree, polynomial.degree(variable(phase)));
    }
    return degree;
}

EntireFunction EntireQuotients::generator(std::size_t which) const {
    EntireFunction::Term term{1, std::vector<unsigned>(generators_.entire().count())};
    term.powers[which] = 1;
    return {{std::move(term)}};
}

/// Returns the function with x^k y^(n-k) for t^k, where n is the degree in t.
EntireFunction EntireQuotients::homogeneous(const Element::Terms& polynomials) const {
    EntireFunction result;
    for (const auto& [algebraics, polynomial] : polynomials) {
        for (const IntegerMultivariate::Term& term : polynomial.terms()) {
            EntireFunction::Term& added = result.terms.emplace_back();
            added.coefficient = generators_.exact(Element(term.coefficient));
            added.powers = powers_of(term.powers, algebraics);
            for (std::size_t p = 0; p < phase_count(); ++p) {
                added.powers[EntireGenerators::y(p)] =
                    degree_of(polynomials, p) - added.powers[EntireGenerators::x(p)];
            }
        }
    }
    return result;
}

/// Returns the powers of all generators but the y, from the powers of a polynomial's variables and
/// of algebraic numbers.
std::vector<unsigned> EntireQuotients::powers_of(const std::vector<unsigned>& variables,
                                                 const Monomial& algebraics) const {
    const EntireGenerators& entire = generators_.entire();
    std::vector<unsigned> result(entire.count());
    for (std::size_t i = 0; i < variables.size(); ++i) {
        if (variables[i] == 0) { continue; }
        if (i == generators_.parameter_variable()) {
            result[EntireGenerators::w()] = variables[i];
        } else if (const auto phase = generators_.phase_of(i)) {
            result[EntireGenerators::x(*phase)] = variables[i];
        } else {
            result[entire.constant(generators_.constant(i))] = variables[i];
        }
    }
    for (std::size_t i = 0; i < algebraics.size(); ++i) {
        if (algebraics[i] == 0) { continue; }
        result[entire.constant(generators_.algebraic_constant(i))] = algebraics[i];
    }
    return result;
}

/// Returns whether a function has zeros. NOTE: w = 0 is treated by itself.
bool EntireQuotients::has_zeros(const EntireFunction& function) const {
    const EntireGenerators& entire = generators_.entire();
    if (is_generator(function, EntireGenerators::w())) { return false; }
    for (std::size_t p = 0; p < phase_count(); ++p) {
        const bool is_phase = is_generator(function, EntireGenerators::x(p)) ||
                              is_generator(function, EntireGenerators::y(p));
        if (is_phase) { return entire.phases[p].kind == Phase::Kind::angle; }
    }
    return std::any_of(function.terms.begin(), function.terms.end(), [&](const auto& term) {
        return std::any_of(term.powers.begin(),
                           term.powers.begin() + static_cast<long>(entire.variables()),
                           [](unsigned power) { return power != 0; });
    });
}

}  // namespace hvi::gen
