// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/methods/galerkin_rule.hpp"

#include <utility>

#include "generator/exact/algebra/matrix.hpp"
#include "generator/exact/methods/ingredients.hpp"
#include "generator/exact/methods/interpolation.hpp"
#include "generator/exact/methods/number_stages.hpp"
#include "generator/exact/methods/rational_rule.hpp"
#include "generator/support/progress.hpp"

namespace hvi::gen {

namespace {

void check_distinct(const Method& method, const NumberVector& c) {
    for (std::size_t i = 0; i < c.size(); ++i) {
        for (std::size_t j = i + 1; j < c.size(); ++j) {
            if (!(c[i] - c[j]).is_zero()) { continue; }
            throw MathError("nodes " + std::to_string(i + 1) + " and " + std::to_string(j + 1) +
                                " are equal, and no interpolatory rule has both",
                            whole(method.nodes.source),
                            "give distinct nodes, or --weights of your own");
        }
    }
}

/// Returns the product of (x - c_k), by ascending powers.
NumberVector node_polynomial(const NumberVector& c) {
    NumberVector P{Number(1)};
    for (const Number& node : c) {
        P.insert(P.begin(), Number(0));
        for (std::size_t k = 0; k + 1 < P.size(); ++k) { P[k] = P[k] - node * P[k + 1]; }
    }
    return P;
}

/// Returns b_j: the integral over [0,1] of P/(x - c_j), divided by its value at c_j.
Number interpolatory_weight(const NumberVector& P, const Number& node) {
    Number coefficient, integral, value;
    for (std::size_t k = P.size() - 1; k-- > 0;) {  // Horner's scheme
        coefficient = P[k + 1] + node * coefficient;
        integral = integral + coefficient / Number(static_cast<long>(k) + 1);
    }
    Number slope;  // slope of P at the node, which is the value of P/(x - c_j) there
    for (std::size_t k = P.size(); k-- > 1;) {
        slope = slope * node + P[k] * Number(static_cast<long>(k));
    }
    return integral / slope;
}

NumberVector interpolatory_weights(const Method& method, const Ingredients& given) {
    const Progress::Stage stage("computing the weights");
    const auto r = static_cast<long>(given.nodes.c.size());
    if (given.nodes.polynomial) {
        std::vector<RationalPolynomial> powers{RationalPolynomial(1)};
        for (long k = 1; k < r; ++k) {
            powers.push_back(powers.back() * RationalPolynomial::variable());
        }
        auto known = interpolate(powers, *given.nodes.polynomial, given.nodes.c, given.ground);
        if (known) { return std::move(known->b); }
    }
    check_distinct(method, given.nodes.c);
    const NumberVector P = node_polynomial(given.nodes.c);
    NumberVector weights;
    for (const Number& node : given.nodes.c) { weights.push_back(interpolatory_weight(P, node)); }
    return weights;
}

/// Returns whether a function is a polynomial that an interpolatory rule with so many nodes
/// integrates.
bool is_polynomial_below(const ExactFunction& function, std::size_t degree) {
    if (!function.is_polynomial()) { return false; }
    for (const ExactTerm& term : function.terms()) {
        if (term.power >= degree) { return false; }
    }
    return true;
}

/// Returns sum_i b_i f_i.
Number applied(const NumberVector& b, const NumberVector& f) {
    Number sum;
    for (std::size_t i = 0; i < b.size(); ++i) { sum = sum + b[i] * f[i]; }
    return sum;
}

/// Returns sum_i b_i f(c_i) g(c_i), for polynomials over Q at the roots of P by an interpolatory
/// rule.
Number rational_product(const RationalPolynomial& f, const RationalPolynomial& g,
                        const Ingredients& given) {
    const RationalPolynomial rest = remainder(f * g, *given.nodes.polynomial);
    return given.ground.rational(rest.integral_over_unit_interval(), "1");
}

/// Returns whether the weights are interpolatory at all roots of a polynomial over Q.
bool is_rational(const Method& method, const Ingredients& given) {
    return !method.weights && given.nodes.polynomial.has_value();
}

Number integral_by_rule(const Method& method, const Ingredients& given, const GalerkinRule& rule,
                        std::size_t j) {
    const auto f = as_polynomial(given.psi[j].function);
    return is_rational(method, given) && f ? rational_product(*f, RationalPolynomial(1), given)
                                           : applied(rule.b, rule.Psi[j]);
}

/// Checks that the rule is exact on the span. NOTE: functions that interpolation integrates exactly
/// are not checked, as enclosures could not prove it.
void check_exact(const Method& method, const Ingredients& given, const GalerkinRule& rule) {
    const Progress::Stage stage("integrating the basis by the rule");
    for (std::size_t j = 0; j < rule.functions(); ++j) {
        const BasisFunction& psi = given.psi[j];
        if (!method.weights && is_polynomial_below(psi.function, rule.nodes())) { continue; }
        const Number defect = integral_by_rule(method, given, rule, j) - rule.B[j];
        if (defect.is_zero()) { continue; }
        throw MathError("the rule is not exact on the span of the basis, so the method is not "
                        "consistent: for `" +
                            to_text(psi.form) + "` it is off by " + text_of(defect),
                        psi.place,
                        "take nodes and weights that integrate the basis, or as many nodes as "
                        "functions");
    }
}

NumberMatrix gram(const Method& method, const Ingredients& given, const GalerkinRule& rule) {
    const Progress::Stage stage("computing the Gram matrix");
    const bool rational = is_rational(method, given);
    NumberMatrix G(rule.functions(), NumberVector(rule.functions()));
    for (std::size_t j = 0; j < rule.functions(); ++j) {
        const auto f = as_polynomial(given.psi[j].function);
        for (std::size_t k = 0; k <= j; ++k) {
            const auto g = as_polynomial(given.psi[k].function);
            if (rational && f && g) {
                G[j][k] = rational_product(*f, *g, given);
            } else {
                NumberVector products = rule.Psi[j];
                for (std::size_t i = 0; i < rule.nodes(); ++i) {
                    products[i] = products[i] * rule.Psi[k][i];
                }
                G[j][k] = applied(rule.b, products);
            }
            G[k][j] = G[j][k];
        }
    }
    return G;
}

std::shared_ptr<const RationalRule> over_rationals(const Method& method, const Ingredients& given) {
    if (!is_rational(method, given)) { return nullptr; }
    RationalRule result{*given.nodes.polynomial, {}};
    for (const BasisFunction& psi : given.psi) {
        auto polynomial = as_polynomial(psi.function);
        if (!polynomial) { return nullptr; }
        result.psi.push_back(*std::move(polynomial));
    }
    return std::make_shared<const RationalRule>(std::move(result));
}

NumberMatrix inverse_gram(const Method& method, const Ingredients& given, const NumberMatrix& G) {
    const Progress::Stage stage("inverting the Gram matrix");
    if (const auto known = inverse(G)) {
        return known->adjugate * (Number(1) / known->determinant);
    }
    const auto combination = left_null_vector(G);
    HVI_CHECK(combination);
    check_dependence(method, *combination, given.psi);
    throw MathError("the Gram matrix of the basis is singular: the rule sees nothing of " +
                        combination_text(*combination, given.psi),
                    whole(method.nodes.source),
                    "choose other nodes or weights, or other functions");
}

/// Returns n_ij = c_i - A_i G^-1 A_j^T. NOTE: A_i is 0 at the node 0, and G^-1 A_j^T are the
/// coefficients of 1 at the node 1. Enclosures would not prove the zeros that follow.
NumberMatrix positions(const GalerkinRule& rule, const NumberMatrix& inverse) {
    const std::size_t r = rule.nodes();
    NumberMatrix n(r, NumberVector(r));
    const auto symmetric = [&](std::size_t i, std::size_t j) {
        if (rule.c[i].is_zero() || rule.c[j].is_zero()) { return Number(0); }
        if (rule.c[i].is_one()) { return rule.c[j]; }
        if (rule.c[j].is_one()) { return rule.c[i]; }
        return applied(rule.A_psi[i], inverse * rule.A_psi[j]);
    };
    for (std::size_t i = 0; i < r; ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
            const Number S = symmetric(i, j);
            n[i][j] = rule.c[i] - S;
            n[j][i] = rule.c[j] - S;
        }
    }
    return n;
}

}  // namespace

NystromTableau nystrom(const GalerkinRule& rule) {
    NystromTableau result{rule.n, rule.b};
    for (std::size_t j = 0; j < rule.nodes(); ++j) {
        for (NumberVector& row : result.A_bar) { row[j] = rule.b[j] * row[j]; }
        result.b_bar[j] = rule.b[j] * (Number(1) - rule.c[j]);
    }
    return result;
}

PartitionedMethod partitioned_method(const GalerkinRule& rule) {
    const auto known = inverse(rule.gram);
    HVI_CHECK(known);
    const NumberMatrix W =
        known->adjugate * transpose(rule.A_psi) * (Number(1) / known->determinant);
    PartitionedMethod method{rule.b, rule.b, transpose(W) * rule.Psi, transpose(rule.Psi) * W};
    for (std::size_t j = 0; j < rule.nodes(); ++j) {
        for (NumberVector& row : method.A) { row[j] = rule.b[j] * row[j]; }
        for (NumberVector& row : method.A_tilde) { row[j] = rule.b[j] * (Number(1) - row[j]); }
    }
    return method;
}

NumberMatrix projection(const GalerkinRule& rule) {
    const auto known = inverse(rule.gram);
    HVI_CHECK(known);
    NumberMatrix result =
        transpose(rule.Psi) * (known->adjugate * rule.Psi * (Number(1) / known->determinant));
    for (NumberVector& row : result) {
        for (std::size_t j = 0; j < rule.nodes(); ++j) { row[j] = row[j] * rule.b[j]; }
    }
    return result;
}

GalerkinRule galerkin_rule(const Method& method, const Ingredients& given) {
    const auto& [ground, psi, nodes] = given;
    HVI_CHECK(nodes.c.size() > psi.size());
    check_constants(method, psi);
    GalerkinRule rule;
    rule.provenance = provenance(method, psi);
    rule.c = nodes.c;
    rule.b = method.weights ? given_weights(method, given) : interpolatory_weights(method, given);
    rule.parameters = ground.free_parameters();  // with those of the weights
    rule.Psi = values(psi, nodes.c, ground);
    auto [B, A_psi] = basis_integrals(given);
    rule.B = std::move(B);
    rule.A_psi = std::move(A_psi);
    check_parameters(method, {{rule.c, rule.b, rule.B}, rule.Psi, rule.A_psi});
    check_exact(method, given, rule);
    rule.gram = gram(method, given, rule);
    rule.n = positions(rule, inverse_gram(method, given, rule.gram));
    rule.over_rationals = over_rationals(method, given);
    return rule;
}

}  // namespace hvi::gen
