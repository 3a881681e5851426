// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/methods/oscillator.hpp"

#include <algorithm>
#include <utility>

#include "generator/exact/algebra/matrix.hpp"
#include "generator/exact/algebra/polynomial_in_square.hpp"
#include "generator/exact/methods/composition.hpp"
#include "generator/exact/methods/even_map.hpp"
#include "generator/exact/methods/properties.hpp"
#include "generator/exact/numbers/number_value.hpp"
#include "generator/exact/numbers/rational.hpp"
#include "generator/support/progress.hpp"

namespace hvi::gen {

namespace {

bool has_parameters(const EvenMap& map) {
    for (const NumberPolynomial* entry : {&map.m11, &map.m12, &map.m21, &map.m22, &map.D}) {
        for (const Number& coefficient : *entry) {
            if (coefficient.has_parameters()) { return true; }
        }
    }
    return false;
}

/// Returns both divided by their common divisor, and by the denominator's value at 0.
PolynomialQuotient reduced(const NumberPolynomial& numerator, const NumberPolynomial& denominator,
                           PolynomialArithmetic& arithmetic) {
    const NumberPolynomial above = arithmetic.without(numerator, denominator);
    const NumberPolynomial below = arithmetic.without(denominator, numerator);
    const Number scale = Number(1) / below.front();
    return {above * scale, below * scale};
}

void divide_by_common(EvenMap& map, PolynomialArithmetic& arithmetic) {
    NumberPolynomial common = map.D;
    for (const NumberPolynomial* entry : {&map.m11, &map.m22, &map.m12, &map.m21}) {
        if (common.size() > 1) { common = arithmetic.gcd(common, *entry); }
    }
    for (NumberPolynomial* entry : {&map.m11, &map.m12, &map.m21, &map.m22, &map.D}) {
        if (common.size() > 1) { *entry = arithmetic.divide(*entry, common).quotient; }
    }
}

void make_D_one_at_zero(EvenMap& map) {
    const Number scale = Number(1) / map.D.front();
    if (is_exactly(scale, 1)) { return; }
    for (NumberPolynomial* entry : {&map.m11, &map.m12, &map.m21, &map.m22, &map.D}) {
        *entry = *entry * scale;
    }
}

/// Returns z^shift P(z^2).
NumberPolynomial in_z(const NumberPolynomial& polynomial, std::size_t shift) {
    NumberPolynomial result;
    for (std::size_t k = 0; k < polynomial.size(); ++k) {
        result.resize(2 * k + shift);
        result.push_back(polynomial[k]);
    }
    return result;
}

/// Returns whether m11 m22 - t m12 m21 = D^2.
Verdict has_determinant_one(const EvenMap& map, PolynomialArithmetic& arithmetic) {
    const NumberPolynomial diagonal = product(map.m11, map.m22);
    const NumberPolynomial other = shifted(product(map.m12, map.m21));
    const NumberPolynomial square = product(map.D, map.D);
    const auto coefficient = [](const NumberPolynomial& polynomial, std::size_t k) {
        return k < polynomial.size() ? polynomial[k] : Number(0);
    };
    Verdict verdict;
    for (std::size_t k = 0; k < std::max({diagonal.size(), other.size(), square.size()}); ++k) {
        const Number difference =
            coefficient(diagonal, k) - coefficient(other, k) - coefficient(square, k);
        const bool holds = arithmetic.is_zero(difference);
        verdict = verdict && Verdict{holds, !holds || is_exact(difference)};
        if (!holds) { break; }
    }
    return verdict;
}

/// Returns the polynomials in t of a map. Where they are not rational they are enclosed: products
/// of exact ones would take minutes.
EvenMap even_map(const OscillatorMap& map) {
    EvenMap result{even(map.m11), odd(map.m12), odd(map.m21), even(map.m22), even(map.D)};
    for (NumberPolynomial* entry :
         {&result.m11, &result.m12, &result.m21, &result.m22, &result.D}) {
        if (!over_rationals(*entry)) { *entry = without_closed_form(*entry); }
    }
    return result;
}

/// Returns P(factor t).
NumberPolynomial stretched(NumberPolynomial polynomial, const Number& factor) {
    Number power(1);
    for (Number& coefficient : polynomial) {
        coefficient = coefficient * power;
        power = power * factor;
    }
    return polynomial;
}

/// Returns the map of a step of size gamma h.
EvenMap stretched(const EvenMap& map, const Number& gamma) {
    const auto all = [&](const NumberPolynomial& entry) { return stretched(entry, gamma * gamma); };
    return {all(map.m11), all(map.m12) * gamma, all(map.m21) * gamma, all(map.m22), all(map.D)};
}

/// Returns the map of `right`, then `left`.
EvenMap product(const EvenMap& left, const EvenMap& right) {
    return {sum(product(left.m11, right.m11), shifted(product(left.m12, right.m21))),
            sum(product(left.m11, right.m12), product(left.m12, right.m22)),
            sum(product(left.m21, right.m11), product(left.m22, right.m21)),
            sum(shifted(product(left.m21, right.m12)), product(left.m22, right.m22)),
            product(left.D, right.D)};
}

/// Returns the map without the verdict on the determinant.
OscillatorMap normalized(EvenMap& map, PolynomialArithmetic& arithmetic) {
    const bool parameters = has_parameters(map);
    if (!parameters) { divide_by_common(map, arithmetic); }
    make_D_one_at_zero(map);
    const NumberPolynomial trace = arithmetic.sum(map.m11, Number(1), map.m22);
    const NumberPolynomial half = trace * (Number(1) / Number(2));
    const PolynomialQuotient half_trace =
        parameters ? PolynomialQuotient{half, map.D} : reduced(half, map.D, arithmetic);
    const bool proved = arithmetic.proved();
    return {in_z(map.m11, 0),
            in_z(map.m12, 1),
            in_z(map.m21, 1),
            in_z(map.m22, 0),
            in_z(map.D, 0),
            {in_z(half_trace.numerator, 0), in_z(half_trace.denominator, 0)},
            {},
            proved};
}

OscillatorMap completed(EvenMap map, PolynomialArithmetic arithmetic) {
    OscillatorMap result = normalized(map, arithmetic);
    result.determinant_one = has_determinant_one(map, arithmetic);
    return result;
}

/// Returns the map of Algorithm 4.3. NOTE: the determinant follows from the theorem that a
/// symplectic method has a symplectic map: products of the map's coefficients, rational functions
/// of the parameters, would take minutes.
OscillatorMap in_basis(const ButcherPair& pair, const Galerkin& galerkin) {
    EvenMap map = even_map_in_basis(galerkin, pair.b);
    PolynomialArithmetic arithmetic;
    OscillatorMap result = normalized(map, arithmetic);
    result.determinant_one = is_symplectic(partitioned_method(pair));
    HVI_CHECK(result.determinant_one.holds);
    return result;
}

/// Returns whether the map is computed in the basis: where there are free parameters. The minors of
/// more functions are too many.
bool is_for_basis(const Tableau& tableau) {
    constexpr std::size_t most_functions = 8;
    return tableau.galerkin && !tableau.parameters.empty() && tableau.stages() <= most_functions;
}

}  // namespace

OscillatorMap oscillator_map(const Tableau& tableau) {
    const Progress::Stage stage("computing the map of the harmonic oscillator");
    if (const auto* const P = tableau.node_polynomial()) { return completed(even_map(*P), {}); }
    return is_for_basis(tableau) ? in_basis(tableau, *tableau.galerkin)
                                 : oscillator_map(partitioned_method(tableau));
}

OscillatorMap oscillator_map(const PartitionedMethod& method) {
    const Progress::Stage stage("computing the map of the harmonic oscillator");
    PolynomialArithmetic arithmetic;
    EvenMap map = even_map(method, arithmetic);
    return completed(std::move(map), arithmetic);
}

OscillatorMap oscillator_map(const GalerkinRule& rule) {
    const Progress::Stage stage("computing the map of the harmonic oscillator");
    if (rule.over_rationals) { return completed(even_map(*rule.over_rationals), {}); }
    return oscillator_map(partitioned_method(rule));
}

OscillatorMap oscillator_map(EvenMap map) { return completed(std::move(map), {}); }

// The inverse of the step with -z, the adjoint, has m11 and m22 exchanged, as the determinant is 1.
OscillatorMap composed(const OscillatorMap& method, const Composition& composition) {
    const EvenMap own = even_map(method);
    EvenMap adjoint = own;
    std::swap(adjoint.m11, adjoint.m22);
    EvenMap map{{Number(1)}, {}, {}, {Number(1)}, {Number(1)}};
    bool is_adjoint = false;
    for (const Number& gamma : composition.steps) {
        map = product(stretched(is_adjoint ? adjoint : own, gamma), map);
        is_adjoint = composition.with_adjoint && !is_adjoint;
    }
    return completed(std::move(map), {});
}

bool takes_long(const PartitionedMethod& method) {
    constexpr std::size_t most_characters = 8000;     // of rational numbers
    constexpr std::size_t most_enclosed_stages = 32;  // where s^4 numbers are kept
    std::size_t characters = 0;
    bool rational = true;
    for (const NumberMatrix* matrix : {&method.A, &method.A_tilde}) {
        for (const NumberVector& row : *matrix) {
            for (const Number& entry : row) {
                const auto text = rational_text(entry);
                rational = rational && text;
                characters += text ? text->size() : 0;
            }
        }
    }
    return characters > most_characters || (!rational && method.stages() > most_enclosed_stages);
}

bool takes_long(const GalerkinRule& rule) {
    return rule.over_rationals == nullptr && takes_long(partitioned_method(rule));
}

bool takes_long(const Tableau& tableau) {
    constexpr std::size_t most_terms = 1200;  // four stages have 800, and five 2100
    if (tableau.node_polynomial() != nullptr || tableau.parameters.empty()) { return false; }
    const std::size_t terms = is_for_basis(tableau)
                                  ? term_count_in_basis(*tableau.galerkin, tableau.b)
                                  : term_count(tableau.A) + term_count(tableau.A_tilde);
    return terms > most_terms;
}

}  // namespace hvi::gen
