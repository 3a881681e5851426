// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/methods/galerkin.hpp"

#include <algorithm>

#include "generator/exact/algebra/matrix.hpp"
#include "generator/exact/methods/galerkin_rule.hpp"
#include "generator/exact/methods/ingredients.hpp"
#include "generator/exact/methods/interpolation.hpp"
#include "generator/exact/methods/splitting.hpp"
#include "generator/exact/numbers/budget.hpp"
#include "generator/exact/numbers/rational.hpp"
#include "generator/support/progress.hpp"

namespace hvi::gen {

namespace {

void check_counts(const Method& method, const Ingredients& given) {
    const std::size_t functions = given.psi.size();
    const std::size_t nodes = given.nodes.c.size();
    if (nodes < functions) {
        throw MathError("fewer nodes (" + std::to_string(nodes) + ") than basis functions (" +
                            std::to_string(functions) + ")",
                        whole(method.nodes.source), "every function needs a node of its own");
    }
}

/// Returns M^-1 and b by interpolation, for polynomials over Q at all the roots of one.
std::optional<Interpolation> interpolation(const Ingredients& given) {
    if (!given.nodes.polynomial) { return std::nullopt; }
    std::vector<RationalPolynomial> psi;
    for (const BasisFunction& function : given.psi) {
        auto polynomial = as_polynomial(function.function);
        const auto s = static_cast<long>(given.psi.size());
        if (!polynomial || polynomial->degree() >= s) { return std::nullopt; }
        psi.push_back(*std::move(polynomial));
    }
    return interpolate(psi, *given.nodes.polynomial, given.nodes.c, given.ground);
}

ScaledInverse invert(const NumberMatrix& M, const Method& method, const Ingredients& given) {
    const Progress::Stage stage("inverting M");
    if (auto result = inverse(M)) return *std::move(result);
    for (std::size_t i = 0; i < given.nodes.c.size(); ++i) {
        for (std::size_t j = i + 1; j < given.nodes.c.size(); ++j) {
            if (!(given.nodes.c[i] - given.nodes.c[j]).is_zero()) continue;
            throw MathError("M is singular: nodes " + std::to_string(i + 1) + " and " +
                                std::to_string(j + 1) + " are equal",
                            whole(method.nodes.source), "the nodes must be distinct");
        }
    }
    const auto combination = left_null_vector(M);
    HVI_CHECK(combination);
    check_dependence(method, *combination, given.psi);
    throw MathError("M is singular: " + combination_text(*combination, given.psi) +
                        " vanishes at all nodes",
                    whole(method.nodes.source), "choose other nodes, or other functions");
}

/// Returns whether the basis spans the polynomials of degree less than s. Precondition: M is
/// regular.
bool spans_polynomials(const std::vector<BasisFunction>& psi) {
    for (const BasisFunction& function : psi) {
        if (!function.function.is_polynomial()) { return false; }
        for (const ExactTerm& term : function.function.terms()) {
            if (term.power >= psi.size()) { return false; }
        }
    }
    return true;
}

/// Returns how many degrees more than interpolation gives the rule is exact for. It vanishes on the
/// multiples of the nodes' polynomial P, so this is the largest k for which the integrals of P, P
/// tau, ..., P tau^(k-1) vanish, at most s. 0 where that is not known.
std::size_t degrees_beyond_interpolation(const Ingredients& given) {
    if (!given.nodes.polynomial || !spans_polynomials(given.psi)) { return 0; }
    RationalPolynomial multiple = *given.nodes.polynomial;
    std::size_t degrees = 0;
    while (multiple.integral_over_unit_interval() == "0") {
        multiple = multiple * RationalPolynomial::variable();
        ++degrees;
    }
    return degrees;
}

void check_weights(const ButcherPair& pair, const Method& method) {
    for (std::size_t i = 0; i < pair.stages(); ++i) {
        if (!pair.b[i].is_zero()) continue;
        throw MathError("the weight of " + node_text(pair.c, i) +
                            ", is zero, and step 5 divides by it",
                        whole(method.nodes.source),
                        "the general Galerkin form, with more nodes than functions, can have such "
                        "nodes");
    }
}

struct PartnerRow {
    NumberVector entries;
    Number sum;
};

/// Returns a~_ij = b_j (1 - a_ji/b_i) = b_j (b_i - a_ji)/b_i for all j. NOTE: exact numbers are
/// divided last, and their sum once: in a field with generators the quotient is by far the longest
/// of them. Where enclosures are involved a_ji/b_i comes first: it is exactly 0 or 1 where a_ji is
/// 0 or b_i.
PartnerRow partner_row(const ButcherPair& pair, std::size_t i) {
    const NumberVector& b = pair.b;
    const bool exact = std::all_of(b.begin(), b.end(), is_exact) &&
                       std::all_of(pair.A.begin(), pair.A.end(),
                                   [&](const NumberVector& row) { return is_exact(row[i]); });
    PartnerRow result;
    for (std::size_t j = 0; j < pair.stages(); ++j) {
        const Number& a = pair.A[j][i];
        const Number numerator = exact ? b[j] * (b[i] - a) : b[j] * (Number(1) - a / b[i]);
        result.entries.push_back(exact ? numerator / b[i] : numerator);
        result.sum = result.sum + numerator;
    }
    if (exact) { result.sum = result.sum / b[i]; }
    return result;
}

/// Does step 5, and computes the row sums c~. With interpolating polynomials two facts need no
/// computation, which enclosures could not prove:
///
/// A rule exact for one degree more has sum_j b_j a_ji = b_i (1 - c_i), the integral of
/// (1 - tau) phi_i, and so sum_j a~_ij = c_i.
///
/// A rule exact for s degrees more, which is Gauss', has for k = 1 .. s in the same way sum_j b_j
/// c_j^(k-1) a_ji = b_i (1 - c_i^k)/k, the integral of (1 - tau^k)/k phi_i, and so sum_j a~_ij
/// c_j^(k-1) = c_i^k/k. These s equations determine row i of A~, and row i of A satisfies them: A~
/// = A.
void complete_partner(ButcherPair& pair, const Ingredients& given) {
    const Progress::Stage stage("computing the partner tableau");
    const std::size_t s = pair.stages();
    const std::size_t degrees = degrees_beyond_interpolation(given);
    if (degrees >= s) {
        pair.A_tilde = pair.A;
        pair.c_tilde = pair.c;
        return;
    }
    for (std::size_t i = 0; i < s; ++i) {
        auto [row, sum] = partner_row(pair, i);
        pair.A_tilde.push_back(std::move(row));
        pair.c_tilde.push_back(degrees >= 1 ? pair.c[i] : std::move(sum));
    }
}

/// M^-1 = adjugate * scale, and the weights where interpolation gives them.
struct Inversion {
    NumberMatrix adjugate;
    Number scale;
    std::optional<NumberVector> weights;
};

/// Sets `M_inverse`, and `node_polynomial` where there is one.
Inversion inversion(Galerkin& galerkin, const Method& method, const Ingredients& given) {
    if (auto known = interpolation(given)) {
        galerkin.node_polynomial =
            std::make_shared<const RationalPolynomial>(*given.nodes.polynomial);
        galerkin.M_inverse = known->M_inverse;
        return {std::move(known->M_inverse), Number(1), std::move(known->b)};
    }
    ScaledInverse inverse = invert(galerkin.M, method, given);
    const Number scale = Number(1) / inverse.determinant;
    for (const NumberVector& row : inverse.adjugate) { galerkin.M_inverse.push_back(row * scale); }
    return {std::move(inverse.adjugate), scale, std::nullopt};
}

/// Does steps 3 to 5.
ButcherPair butcher_pair(const Galerkin& galerkin, const Inversion& M, const Method& method,
                         const Ingredients& given) {
    const auto times_inverse = [&](const NumberVector& v) { return M.adjugate * v * M.scale; };
    ButcherPair pair;
    pair.c = given.nodes.c;
    pair.b = M.weights ? *M.weights : times_inverse(galerkin.B);
    check_weights(pair, method);
    for (std::size_t i = 0; i < pair.stages(); ++i) {
        pair.A.push_back(pair.c[i].is_one() ? pair.b : times_inverse(galerkin.A_psi[i]));
    }
    complete_partner(pair, given);
    return pair;
}

/// Throws MathError where given weights differ from b = M^-1 B: with as many nodes as functions no
/// others are consistent.
void check_given_weights(const Method& method, const ButcherPair& pair, const Ingredients& given) {
    if (!method.weights) { return; }
    const NumberVector b = given_weights(method, given);
    for (std::size_t i = 0; i < pair.stages(); ++i) {
        const Number difference = b[i] - pair.b[i];
        if (difference.is_zero()) { continue; }
        throw MathError("with as many nodes as functions the rule has to be exact on the span of "
                        "the basis, so that its weights are M^-1 B: that of " +
                            node_text(pair.c, i) + ", is off by " + text_of(difference),
                        method.weights->place(method.weights->items[i].range),
                        "leave out --weights, or give more nodes than functions");
    }
}

Tableau derive(const Method& method, const Ingredients& given) {
    const auto& [ground, psi, nodes] = given;
    Galerkin galerkin;
    galerkin.M = values(psi, nodes.c, ground);
    check_parameters(method, {{nodes.c}, galerkin.M});
    const Inversion M = inversion(galerkin, method, given);
    check_constants(method, psi);
    auto [B, A_psi] = basis_integrals(given);
    galerkin.B = std::move(B);
    galerkin.A_psi = std::move(A_psi);
    check_parameters(method, {{nodes.c, galerkin.B}, galerkin.M, galerkin.A_psi});
    ButcherPair pair = butcher_pair(galerkin, M, method, given);
    check_given_weights(method, pair, given);
    return {std::move(pair), provenance(method, psi), ground.free_parameters(),
            std::move(galerkin)};
}

/// Returns sum_k coefficients[k] functions[k].
ExactFunction combine(const NumberVector& coefficients,
                      const std::vector<BasisFunction>& functions) {
    ExactFunction sum;
    for (std::size_t k = 0; k < functions.size(); ++k) {
        sum = sum + ExactFunction(coefficients[k]) * functions[k].function;
    }
    return sum;
}

}  // namespace

Derivation derive_on(const Ground& ground, const Method& method) {
    const Progress::Stage stage("reading nodes and basis exactly");
    const Ingredients given = ingredients(method, ground);
    check_counts(method, given);
    if (given.nodes.c.size() > given.psi.size()) {
        throw InputError("more nodes than functions make no tableau, but the general Galerkin form "
                         "(4.6), which is not built for this yet",
                         whole(method.nodes.source), "give as many nodes as basis functions");
    }
    try {
        return {derive(method, given), given.ground};
    } catch (const TooLarge& error) {
        throw MathError(error.what(), whole(method.basis.source), error.help());
    }
}

Tableau derive(const Method& method) {
    return on_new_ground([&](const Ground& ground) { return derive_on(ground, method).tableau; });
}

AnyDerivation derive_any_on(const Ground& ground, const Method& method) {
    if (!method.splitting.empty()) { return {splitting_tableau(ground, method), ground}; }
    const Progress::Stage stage("reading nodes and basis exactly");
    const Ingredients given = ingredients(method, ground);
    check_counts(method, given);
    try {
        if (given.nodes.c.size() > given.psi.size()) {
            return {galerkin_rule(method, given), given.ground};
        }
        return {derive(method, given), given.ground};
    } catch (const TooLarge& error) {
        throw MathError(error.what(), whole(method.basis.source), error.help());
    }
}

DerivedMethod derive_any(const Method& method) {
    return on_new_ground(
        [&](const Ground& ground) { return derive_any_on(ground, method).method; });
}

Routes both_routes(const Method& method) {
    return on_new_ground([&](const Ground& ground) {
        const Ingredients given = ingredients(method, ground);
        const Tableau tableau = derive(method, given);
        Routes routes{{tableau.b, tableau.A}, {}};
        std::vector<BasisFunction> phi;
        for (const NumberVector& row : tableau.galerkin->M_inverse) {
            phi.push_back({Expression(), combine(row, given.psi), whole(method.basis.source)});
        }
        routes.by_integration.b = integrals(phi, Number(1), given.ground);
        for (const Number& node : tableau.c) {
            routes.by_integration.A.push_back(integrals(phi, node, given.ground));
        }
        return routes;
    });
}

}  // namespace hvi::gen
