// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/methods/curve.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "generator/exact/algebra/matrix.hpp"
#include "generator/exact/algebra/number_polynomial.hpp"
#include "generator/exact/expressions/basis.hpp"
#include "generator/exact/methods/galerkin.hpp"
#include "generator/exact/methods/ingredients.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

Number whole_number(std::size_t n) { return {static_cast<long>(n)}; }

/// Returns the integral of polynomial * tau^power over [0,1].
Number moment(const NumberPolynomial& polynomial, std::size_t power) {
    Number sum;
    for (std::size_t i = 0; i < polynomial.size(); ++i) {
        sum = sum + polynomial[i] / whole_number(i + power + 1);
    }
    return sum;
}

// ---- polynomials ----

/// Returns the integrals of psi_i(tau) P_k(2 tau - 1), for k > 0 up to the highest degree.
NumberMatrix in_legendre_polynomials(const std::vector<BasisFunction>& psi, const Ground& ground) {
    std::vector<NumberPolynomial> polynomials;
    std::size_t size = 0;
    for (const BasisFunction& function : psi) {
        polynomials.push_back(function.function.coefficients());
        size = std::max(size, polynomials.back().size());
    }
    NumberMatrix rows(psi.size());
    for (std::size_t k = 1; k < size; ++k) {
        const NumberPolynomial P =
            with_numbers(legendre(static_cast<unsigned>(k)).at_affine(2, -1), ground);
        for (std::size_t i = 0; i < psi.size(); ++i) {
            rows[i].push_back(moment(product(polynomials[i], P), 0));
        }
    }
    return rows;
}

/// Returns (tau - c_1) ... (tau - c_r), over Q where that is known.
NumberPolynomial node_polynomial(const Nodes& nodes, const Ground& ground) {
    if (nodes.polynomial) { return with_numbers(*nodes.polynomial, ground); }
    NumberPolynomial P{Number(1)};
    for (const Number& c : nodes.c) { P = product(P, {-c, Number(1)}); }
    return P;
}

/// Returns how many degrees more than r - 1 the interpolatory rule of r nodes is proved to be exact
/// for, at most r.
std::size_t degrees_beyond_interpolation(const Nodes& nodes, const Ground& ground) {
    const NumberPolynomial P = node_polynomial(nodes, ground);
    std::size_t degrees = 0;
    while (degrees < nodes.c.size() && moment(P, degrees).known_zero().value_or(false)) {
        ++degrees;
    }
    return degrees;
}

/// Returns how many degrees 0, 1, ... a rule of other weights is proved to be exact for, at most
/// 2r.
std::size_t exact_degrees(const GalerkinRule& rule) {
    NumberVector powers = rule.b;  // b_i c_i^k
    for (std::size_t k = 0; k < 2 * rule.nodes(); ++k) {
        Number sum;
        for (std::size_t i = 0; i < rule.nodes(); ++i) {
            sum = sum + powers[i];
            powers[i] = powers[i] * rule.c[i];
        }
        if (!(sum - Number(1) / whole_number(k + 1)).known_zero().value_or(false)) { return k; }
    }
    return 2 * rule.nodes();
}

// ---- other functions ----

/// The integral factor * A(tau) over [0, tau] of a term without its coefficient.
struct Integral {
    Number factor;
    Antiderivative A;
};

Integral integral(const ExactTerm& term, const BasisFunction& psi) {
    using Kind = Antiderivative::Kind;
    const bool has_wave = term.wave != ExactTerm::Wave::none;
    const bool has_rate = !term.rate.is_zero();
    const int kinds = (term.power > 0 ? 1 : 0) + (has_wave ? 1 : 0) + (has_rate ? 1 : 0);
    if (term.step || term.factor != nullptr || kinds > 1) {
        throw InputError("--dense for this function is announced, but not built yet", psi.place,
                         "sums of tau^k, exp(a*tau), cos(b*tau) and sin(b*tau) have it");
    }
    if (has_rate) { return {Number(1) / term.rate, {Kind::exponential, 0, term.rate}}; }
    if (has_wave) {
        const bool is_cos = term.wave == ExactTerm::Wave::cos;
        return {Number(is_cos ? 1 : -1) / term.frequency,
                {is_cos ? Kind::sine : Kind::cosine, 0, term.frequency}};
    }
    const unsigned power = term.power + 1;
    return {Number(1) / whole_number(power), {Kind::power, power, Number(0)}};
}

/// Coefficients of the psi_i in the A_k. Constants have none: their curve is the chord.
struct InTerms {
    NumberMatrix rows;
    std::vector<Antiderivative> A;
};

InTerms in_terms(const std::vector<BasisFunction>& psi) {
    InTerms result;
    std::vector<ExactTerm> shapes;
    for (const BasisFunction& function : psi) {
        NumberVector row(shapes.size());
        for (const ExactTerm& term : function.function.terms()) {
            if (term.is_monomial() && term.power == 0) { continue; }
            const auto [factor, A] = integral(term, function);
            std::size_t k = 0;
            while (k < shapes.size() && !same_shape(shapes[k], term)) { ++k; }
            if (k == shapes.size()) {
                shapes.push_back(term);
                result.A.push_back(A);
                row.emplace_back();
            }
            row[k] = term.coefficient * factor;
        }
        result.rows.push_back(std::move(row));
    }
    for (NumberVector& row : result.rows) { row.resize(shapes.size()); }
    return result;
}

/// Departures of the antiderivatives of the basis from their chords.
struct Departures {
    NumberMatrix R;  ///< functions psi_k x functions g_l
    std::vector<Antiderivative> A;
    bool spans_polynomials = false;  ///< whether it spans the polynomials of degree less than s
};

Departures departures(const std::vector<BasisFunction>& psi, const Ground& ground) {
    const bool is_polynomial = std::all_of(psi.begin(), psi.end(), [](const auto& function) {
        return function.function.is_polynomial();
    });
    if (!is_polynomial) {
        auto [rows, A] = in_terms(psi);
        return {std::move(rows), std::move(A)};
    }
    NumberMatrix rows = in_legendre_polynomials(psi, ground);
    const bool spans = rows.front().size() + 1 == psi.size();
    return {std::move(rows), {}, spans};
}

void check_no_parameter(const Method& method, const std::vector<std::string>& parameters) {
    if (parameters.empty()) { return; }
    throw InputError("--dense for a method with a free parameter is announced, but not built yet",
                     whole(method.basis.source), "give the parameter a value with --param");
}

Curve curve_of(const Tableau& tableau, const Method& method, const Ingredients& given) {
    check_no_parameter(method, tableau.parameters);
    auto [R, A, spans_polynomials] = departures(given.psi, given.ground);
    const std::size_t s = given.psi.size();
    const std::size_t order =
        spans_polynomials ? std::min(s, degrees_beyond_interpolation(given.nodes, given.ground) + 1)
                          : 1;
    return {tableau.galerkin->M_inverse * R, std::nullopt, std::move(A), order};
}

Curve curve_of(const GalerkinRule& rule, const Method& method, const Ingredients& given) {
    check_no_parameter(method, rule.parameters);
    auto [R, A, spans_polynomials] = departures(given.psi, given.ground);
    const std::size_t s = rule.functions();
    const auto degrees = [&] {
        return method.weights
                   ? exact_degrees(rule)
                   : rule.nodes() + degrees_beyond_interpolation(given.nodes, given.ground);
    };
    const auto G = inverse(rule.gram);
    HVI_CHECK(G);
    const NumberMatrix coefficients = G->adjugate * R * (Number(1) / G->determinant);
    const NumberMatrix at_nodes = transpose(rule.Psi) * coefficients;
    NumberMatrix F;
    for (std::size_t i = 0; i < rule.nodes(); ++i) {
        if (rule.b[i].known_zero() != true) { F.push_back(at_nodes[i] * rule.b[i]); }
    }
    return {std::move(F), rule.A_psi * coefficients * Number(-1), std::move(A),
            spans_polynomials ? std::min(s, degrees() - s + 1) : 1};
}

}  // namespace

Curve curve(const Method& method, const AnyDerivation& derivation) {
    const Ingredients given = ingredients(method, derivation.ground);
    return std::visit([&](const auto& derived) { return curve_of(derived, method, given); },
                      derivation.method);
}

}  // namespace hvi::gen
